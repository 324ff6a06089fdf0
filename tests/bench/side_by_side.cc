// SPDX-License-Identifier: BSD-3-Clause
#include "bench/side_by_side.h"

#include <algorithm>
#include <cmath>

#include "bench/measures/render_drawing.h"
#include "limn/pictures/canvas.h"

namespace limn::bench {
namespace {

constexpr int kSmallImagePx = 1000;
constexpr int kGapPx = 12;
constexpr double kPointRadiusPx = 2;

struct SeenPoint {
  double depth = 0;
  Eigen::Vector2d pixel;
};

// Farthest first.
std::vector<SeenPoint> SeenPoints(const std::vector<Eigen::Vector3d>& cloud, const View& view) {
  std::vector<SeenPoint> seen;
  for (const Eigen::Vector3d& point : cloud) {
    const auto pixel = view.Project(point);
    const auto stored = pixel ? view.StoredFromVirtual(*pixel) : std::nullopt;
    if (stored) seen.push_back({(view.cam_from_world * point).z(), *stored});
  }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const SeenPoint& a, const SeenPoint& b) { return a.depth > b.depth; });
  return seen;
}

Picture RenderCloud(const std::vector<Eigen::Vector3d>& cloud, const View& view, int scale) {
  constexpr double kDarkest = 40, kLightest = 215;
  Canvas canvas(view.camera.width, view.camera.height, scale);
  const std::vector<SeenPoint> points = SeenPoints(cloud, view);
  for (size_t i = 0; i < points.size(); ++i) {
    const double nearness = static_cast<double>(i) / static_cast<double>(points.size());
    const auto gray =
        static_cast<uint8_t>(std::lround(kLightest + nearness * (kDarkest - kLightest)));
    canvas.DrawDisc(points[i].pixel, kPointRadiusPx, {gray, gray, gray});
  }
  return canvas.picture();
}

Picture Beside(const Picture& left, const Picture& right) {
  Picture both{left.width + kGapPx + right.width, std::max(left.height, right.height), {}};
  const auto row_bytes = static_cast<size_t>(3 * both.width);
  both.rgb.assign(row_bytes * both.height, 128);
  const auto copy = [&](const Picture& part, int x) {
    for (int y = 0; y < part.height; ++y) {
      std::copy_n(part.At(0, y), 3 * static_cast<size_t>(part.width),
                  both.rgb.begin() + static_cast<std::ptrdiff_t>(y * row_bytes + 3 * x));
    }
  };
  copy(left, 0);
  copy(right, left.width + kGapPx);
  return both;
}

}  // namespace

Picture DrawSideBySide(const DrawingGraph& graph, const std::vector<Eigen::Vector3d>& cloud,
                       const View& view) {
  PictureOptions options;
  options.node_radius_px = 2;  // many small nodes would hide the curves
  options.scale = std::max(view.camera.width, view.camera.height) < kSmallImagePx ? 2 : 1;
  return Beside(RenderDrawing(graph, view, options), RenderCloud(cloud, view, options.scale));
}

}  // namespace limn::bench
