// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/tracks_writer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <ostream>

#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr double kStepPx = 4;
constexpr int kMaxSteps = 4096;
// Steps of a segment with an end that has no image, where its length in pixels is unknown.
constexpr int kBlindSteps = 64;
// Halvings of a step when looking for the border: 4 px / 2^8 is far below a tenth of a pixel.
constexpr int kHalvings = 24;

using Pixel = std::optional<Eigen::Vector2d>;

Pixel StoredPixel(const View& view, const Eigen::Vector3d& point_in_world) {
  const Pixel pixel = view.Project(point_in_world);
  return pixel ? view.StoredFromVirtual(*pixel) : std::nullopt;
}

class RunBuilder {
 public:
  explicit RunBuilder(const View& view)
      : view_(view), is_convex_(!view.lens && view.region.cell_px == 0) {}

  std::vector<std::vector<Eigen::Vector2d>> Build(const std::vector<Eigen::Vector3d>& points) {
    if (points.empty()) return {};
    Pixel pixel = StoredPixel(view_, points.front());
    if (pixel) runs_.push_back({*pixel});
    for (size_t i = 0; i + 1 < points.size(); ++i) {
      pixel = AddSegment(points[i], pixel, points[i + 1]);
    }
    std::erase_if(runs_, [](const auto& run) { return run.size() < 2; });
    return std::move(runs_);
  }

 private:
  // Returns the pixel of the segment's second point.
  Pixel AddSegment(const Eigen::Vector3d& from, const Pixel& from_pixel,
                   const Eigen::Vector3d& to) {
    const Pixel to_pixel = StoredPixel(view_, to);
    if (!from_pixel && !to_pixel && AreBeyondOneSide(from, to)) return to_pixel;
    int num_steps = kBlindSteps;
    if (from_pixel && to_pixel && is_convex_) {
      num_steps = 1;
    } else if (from_pixel && to_pixel) {
      const double length = (*to_pixel - *from_pixel).norm();
      num_steps = std::clamp(static_cast<int>(std::ceil(length / kStepPx)), 1, kMaxSteps);
    }
    Eigen::Vector3d previous = from;
    Pixel previous_pixel = from_pixel;
    for (int step = 1; step <= num_steps; ++step) {
      const bool last = step == num_steps;
      const Eigen::Vector3d next =
          last ? to : Eigen::Vector3d(from + (static_cast<double>(step) / num_steps) * (to - from));
      const Pixel next_pixel = last ? to_pixel : StoredPixel(view_, next);
      AddStep(previous, previous_pixel, next, next_pixel, last);
      previous = next;
      previous_pixel = next_pixel;
    }
    return to_pixel;
  }

  // Whether both are behind the camera or beyond one border of the image, and hence all between.
  bool AreBeyondOneSide(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    return (Clearances(from).array().max(Clearances(to).array()) < 0).any();
  }

  // How far a point is in front of the camera, and within each border, times depth: linear in it.
  Eigen::Matrix<double, 5, 1> Clearances(const Eigen::Vector3d& point_in_world) const {
    const Eigen::Vector3d in_cam = view_.cam_from_world * point_in_world;
    const PinholeCamera& camera = view_.camera;
    const double x = camera.fx * in_cam.x() + camera.cx * in_cam.z();
    const double y = camera.fy * in_cam.y() + camera.cy * in_cam.z();
    const ImageRegion& region = view_.region;
    Eigen::Matrix<double, 5, 1> clearances;
    clearances << in_cam.z(), x - region.min_px.x() * in_cam.z(),
        region.max_px.x() * in_cam.z() - x, y - region.min_px.y() * in_cam.z(),
        region.max_px.y() * in_cam.z() - y;
    return clearances;
  }

  void AddStep(const Eigen::Vector3d& from, const Pixel& from_pixel, const Eigen::Vector3d& to,
               const Pixel& to_pixel, bool is_vertex) {
    if (!from_pixel && !to_pixel) return;
    if (!from_pixel) runs_.push_back({Border(to, from)});
    if (!to_pixel) {
      runs_.back().push_back(Border(from, to));
    } else if (is_vertex || view_.lens || !from_pixel) {
      // A straight segment stays straight without a lens: its inner points say nothing new.
      runs_.back().push_back(*to_pixel);
    }
  }

  // The last pixel on the way from a visible point to one that is not.
  Eigen::Vector2d Border(Eigen::Vector3d visible, Eigen::Vector3d hidden) const {
    for (int i = 0; i < kHalvings; ++i) {
      const Eigen::Vector3d middle = 0.5 * (visible + hidden);
      (StoredPixel(view_, middle) ? visible : hidden) = middle;
    }
    return *StoredPixel(view_, visible);
  }

  const View& view_;
  bool is_convex_;  // what the image covers: between two visible points all is visible
  std::vector<std::vector<Eigen::Vector2d>> runs_;
};

void PutCoordinate(std::ostream& out, double value) {
  char text[64];
  const auto [end, error] =
      std::to_chars(text, text + sizeof(text), value, std::chars_format::fixed, 3);
  out.write(text, end - text);
}

bool NeedsEscape(const View& view) {
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7F; };
  const std::string& name = view.name;
  return name.starts_with(' ') || name.ends_with(' ') ||
         std::any_of(name.begin(), name.end(), is_control);
}

// Control characters, spaces at either end and backslashes as \xHH.
std::string Escaped(const std::string& name) {
  std::string text;
  for (size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    const bool is_edge = i == 0 || i + 1 == name.size();
    if (c < 0x20 || c == 0x7F || c == '\\' || (c == ' ' && is_edge)) {
      constexpr const char* kDigits = "0123456789ABCDEF";
      text += {'\\', 'x', kDigits[c >> 4], kDigits[c & 15]};
    } else {
      text += name[i];
    }
  }
  return text;
}

void PutTrack(LinkId link, const std::vector<Eigen::Vector2d>& run, const std::string& name,
              std::ostream& out) {
  // COLMAP's center of the top-left pixel is (0.5, 0.5), ours is (0, 0).
  constexpr double kColmapFromOurs = 0.5;
  out << link << ' ' << run.size();
  for (const Eigen::Vector2d& pixel : run) {
    PutCoordinate(out << ' ', pixel.x() + kColmapFromOurs);
    PutCoordinate(out << ' ', pixel.y() + kColmapFromOurs);
  }
  out << ' ' << name << '\n';
}

}  // namespace

std::vector<std::vector<Eigen::Vector2d>> ProjectPolyline(
    const View& view, const std::vector<Eigen::Vector3d>& points_in_world) {
  return RunBuilder(view).Build(points_in_world);
}

void WriteTracks(const DrawingGraph& graph, const LinkSelection& selection,
                 const std::vector<View>& views, std::ostream& out) {
  const auto num_links =
      std::count_if(graph.links.begin(), graph.links.end(),
                    [&](const DrawingLink& link) { return selection.Has(link); });
  out << "# Curve tracks: links of drawing.json in the images that support them, by its ids.\n"
         "# One line per link, image and visible run of the link:\n"
         "#   LINK_ID, NUM_POINTS, POINTS[] as (X, Y), IMAGE_NAME\n"
         "# X, Y are pixels of the image as stored (with its lens distortion), in COLMAP's\n"
         "# convention: the centre of the top-left pixel is (0.5, 0.5). A link is clipped to the\n"
         "# image; parts hidden behind surfaces are not told apart. Links that were not\n"
         "# selected, by default tentative ones and outlines of smooth bodies, are left out; of "
         "rods\n"
         "# there are the outlines, not the center lines, which no image shows.\n"
         "# In panoramas X goes on over the left border, where it is negative, and runs end where\n"
         "# parts of the panorama meet.\n"
      << "# Number of links: " << num_links << " of " << graph.links.size() << '\n';
  const bool escapes = std::any_of(views.begin(), views.end(), NeedsEscape);
  if (escapes) out << "# Some characters of image names are written as \\xHH.\n";
  for (size_t id = 0; id < graph.links.size(); ++id) {
    if (!selection.Has(graph.links[id])) continue;
    for (const ViewId view_id : graph.links[id].supporting_views) {
      if (view_id < 0 || view_id >= static_cast<ViewId>(views.size())) {
        throw InputError("link " + std::to_string(id) + ": supporting view " +
                         std::to_string(view_id) + " does not exist");
      }
      const View& view = views[view_id];
      for (const auto& run : ProjectPolyline(view, graph.links[id].points_in_world)) {
        PutTrack(static_cast<LinkId>(id), run, escapes ? Escaped(view.name) : view.name, out);
      }
    }
  }
}

}  // namespace limn
