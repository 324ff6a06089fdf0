// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/page.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <utility>

#include "colmap_ext/dense_files/dense_cloud.h"
#include "colmap_ext/dense_files/products.h"
#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/verbs/drawing_input.h"
#include "colmap_ext/workspace/model_folder.h"
#include "limn/files/atomic_file.h"
#include "limn/model/drawing_transform.h"
#include "limn/pictures/thumbnail.h"
#include "limn/util/errors.h"
#include "limn/util/printable.h"
#include "limn/viewer/viewer_page.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;
using Points = std::vector<ViewerPoint>;

// Which of `count` things stay when at most `budget` may: as many, evenly spread.
class Thinning {
 public:
  Thinning(uint64_t count, int budget)
      : count_(count), budget_(std::min<uint64_t>(count, static_cast<uint64_t>(budget))) {}

  // To be asked once for each, in order.
  bool Keeps() {
    place_ += budget_;
    if (place_ < count_) return false;
    place_ -= count_;
    return true;
  }

 private:
  uint64_t count_, budget_, place_ = 0;
};

// In the model's coordinates, as its file holds them.
Points SparsePoints(const Project& project, int budget) {
  const SparseModel model = project.ReadModel();
  Thinning thinning(model.points.size(), budget);
  Points points;
  for (const ModelPoint& point : model.points) {
    if (thinning.Keeps()) points.push_back({point.position, point.color});
  }
  return points;
}

Points DensePoints(const Project& project, const std::vector<fs::path>& files, int budget,
                   Console* console) {
  const size_t num_images = CountRegisteredImages(project.layout().model_dir);
  const DenseCloud cloud = OpenClouds(files, project.views(), num_images);
  Thinning thinning(cloud.num_points, budget);
  Points points;
  cloud.points([&](const DensePoint& point) {
    if (thinning.Keeps()) points.push_back({point.position, point.color});
  });
  if (const std::string note = cloud.NoteOnOdd(); !note.empty()) {
    console->Say("WARNING: " + files.front().string() + ": " + note);
  }
  return points;
}

// Empty if there is no such file.
std::string StateOf(const fs::path& file) {
  std::error_code error;
  const auto size = fs::file_size(file, error);
  if (error) return "";
  const auto time =
      static_cast<int64_t>(fs::last_write_time(file, error).time_since_epoch().count());
  const std::string path = fs::absolute(file).lexically_normal().string();
  return path + " " + std::to_string(size) + " " + std::to_string(time) + ";";
}

// What a photograph may take in a page of 1024 px, and all of them together; text in base64.
ThumbnailOptions WithinLimits(int size, size_t num_views) {
  constexpr double kBase64 = 0.75;
  constexpr double kMaxBytes = 200e3 * kBase64, kMaxBytesOfAll = 60e6 * kBase64;
  const double of_one = kMaxBytes * std::pow(size / 1024.0, 2);
  const double share = kMaxBytesOfAll / static_cast<double>(std::max<size_t>(num_views, 1));
  return {size, static_cast<size_t>(std::min(of_one, share))};
}

Eigen::Vector2d Scaled(const Eigen::Vector2d& pixel, double factor) {
  return (factor * (pixel.array() + 0.5) - 0.5).matrix();
}

// The old picture for a view of the same camera, whose pixels may be larger or smaller; nothing if
// it would be off by more than a thousandth of the view's size.
std::optional<ViewerThumbnail> Reused(const PagePhoto& photo, const View& view) {
  const PinholeCamera& camera = view.camera;
  if (photo.camera.width <= 0) return std::nullopt;
  const double factor = camera.width / static_cast<double>(photo.camera.width);
  const double tolerance = 1e-3 * std::max(camera.width, camera.height) + factor;
  const auto is_near = [&](double a, double b) { return std::abs(a - b) <= tolerance; };
  const auto are_near = [&](const Eigen::Vector2d& of_view, const Eigen::Vector2d& of_photo) {
    return (of_view - Scaled(of_photo, factor)).cwiseAbs().maxCoeff() <= tolerance;
  };
  const bool is_same = is_near(camera.height, factor * photo.camera.height) &&
                       is_near(camera.fx, factor * photo.camera.fx) &&
                       is_near(camera.fy, factor * photo.camera.fy) &&
                       are_near({camera.cx, camera.cy}, {photo.camera.cx, photo.camera.cy}) &&
                       are_near(view.region.min_px, photo.region.min_px) &&
                       are_near(view.region.max_px, photo.region.max_px);
  if (!is_same) return std::nullopt;
  return ViewerThumbnail{Scaled(photo.thumbnail.min_px, factor),
                         Scaled(photo.thumbnail.max_px, factor), photo.thumbnail.jpeg};
}

// Those that are at hand; the others are empty.
std::vector<ViewerThumbnail> KnownThumbnails(const std::vector<View>& views,
                                             const std::vector<PagePhoto>& known) {
  std::map<std::string, const PagePhoto*> by_name;
  for (const PagePhoto& photo : known) by_name[photo.name] = &photo;
  std::vector<ViewerThumbnail> thumbnails(views.size());
  for (size_t v = 0; v < views.size(); ++v) {
    const auto found = by_name.find(views[v].name);
    if (found == by_name.end()) continue;
    thumbnails[v] = Reused(*found->second, views[v]).value_or(ViewerThumbnail());
  }
  return thumbnails;
}

// Which of the pictures had to be smaller than asked for.
void SaySmall(const std::vector<int>& sides, int size, Console* console) {
  std::vector<int> small = sides;
  std::erase(small, 0);
  if (small.empty()) return;
  console->Say(std::to_string(small.size()) + " of " + std::to_string(sides.size()) +
               " photographs in the page have less than " + WithCommas(size) +
               " px on the longer side, at least " + WithCommas(std::ranges::min(small)) +
               ": larger ones would make the page too large");
}

void MoveToWorld(const Alignment& alignment, ViewerScene* scene) {
  const Similarity3d& world_from_model = alignment.world_from_model;
  const auto& [scale, rotation, translation] = world_from_model;
  scene->graph = Transformed(std::move(scene->graph), scale, rotation, translation);
  for (View& view : scene->views) {
    view.cam_from_world = CamFromB(view.cam_from_world, world_from_model);
  }
  for (ViewerPoint& point : scene->cloud) point.position = world_from_model * point.position;
  scene->shown_from_model = world_from_model;
  scene->z_is_up = true;
  scene->scale_sigma = alignment.scale_sigma;
  if (alignment.IsMetric()) scene->unit = alignment.Unit();
}

// The alignment of what is shown, if it is the world.
std::optional<Alignment> ShownAlignment(PageOptions::Shown shown, const std::string& drawing_path,
                                        const DrawingMetadata& metadata) {
  if (shown == PageOptions::Shown::kModel) return std::nullopt;
  if (shown == PageOptions::Shown::kWorld) return RequireAlignment(drawing_path, metadata);
  return metadata.alignment;
}

fs::path PageFolder(const Project& project) {
  return fs::absolute(project.DrawingPath("").string()).lexically_normal();
}

DrawingStamp StampOf(const DrawingInScene& drawing, const std::string& drawing_path,
                     const fs::path& folder) {
  const fs::path path = fs::absolute(drawing_path);
  std::error_code ignored;
  const bool is_beside = fs::equivalent(path.parent_path(), folder, ignored);
  return {is_beside ? path.filename().string() : "",
          drawing.fingerprint.empty() ? FingerprintOf(drawing_path) : drawing.fingerprint};
}

}  // namespace

std::string CloudSource(const Project& project, const std::string& workspace_path,
                        const PageOptions& options) {
  if (options.cloud == "none") return "";
  std::vector<fs::path> files;
  if (options.cloud != "sparse") {
    files = FindDenseCloud(workspace_path, project.layout().dense_dir);
  }
  if (files.empty()) {
    for (const char* name : {"points3D.bin", "points3D.txt"}) {
      files.push_back(project.layout().model_dir / name);
    }
  }
  std::string source;
  for (const fs::path& file : files) source += StateOf(file);
  return source;
}

PageCloud MakeCloud(const Project& project, const std::string& workspace_path,
                    const PageOptions& options, Console* console) {
  if (options.cloud == "none") return {};
  const std::string source = CloudSource(project, workspace_path, options);
  if (options.cloud != "sparse") {
    const std::vector<fs::path> files = FindDenseCloud(workspace_path, project.layout().dense_dir);
    if (!files.empty()) {
      console->Say("cloud: " + files.front().string());
      try {
        return {DensePoints(project, files, options.max_points, console), source};
      } catch (const IoError& error) {
        // The page is worth more than its cloud.
        if (options.cloud == "dense") throw;
        console->Say("WARNING: " + std::string(error.what()) + ": shown without the dense cloud");
      }
    }
    if (options.cloud == "dense" && files.empty()) {
      throw IoError(workspace_path, "no dense cloud found (looked for fused.ply and pmvs/models)");
    }
  }
  console->Say("cloud: the points of the model");
  return {SparsePoints(project, options.max_points), source};
}

std::vector<ViewerThumbnail> MakeThumbnails(const Project& project, const std::vector<View>& views,
                                            int size, const std::vector<PagePhoto>& known,
                                            Console* console) {
  const ThumbnailOptions options = WithinLimits(size, views.size());
  std::vector<ViewerThumbnail> thumbnails = KnownThumbnails(views, known);
  std::vector<int> small_sides(views.size());
  ParallelFor(console->context(), "thumbnails", thumbnails.size(), [&](size_t v) {
    if (!thumbnails[v].jpeg.empty()) return;
    const Image photo = project.images().read(static_cast<ViewId>(v));
    Thumbnail made = MakeThumbnail(photo, views[v], options);
    const double extent = (made.max_px - made.min_px).maxCoeff();
    if (made.longer_side < std::lround(std::min<double>(size, extent))) {
      small_sides[v] = made.longer_side;
    }
    thumbnails[v] = {made.min_px, made.max_px, std::move(made.jpeg)};
  });
  ReleaseDecoded(project.view_set());
  SaySmall(small_sides, size, console);
  return thumbnails;
}

ViewerScene MakeViewerScene(const Project& project, const DrawingInScene& drawing,
                            const PageOptions& options, PageParts parts,
                            const std::optional<Alignment>& shown) {
  ViewerScene scene;
  scene.title = PageFolder(project).parent_path().filename().string();
  scene.detail = options.detail;
  scene.graph = Moved(drawing.graph, project.origin());
  scene.views = Moved(drawing.views, project.origin());
  scene.cloud = std::move(parts.cloud.points);
  if (shown) MoveToWorld(*shown, &scene);
  scene.thumbnails = std::move(parts.thumbnails);
  scene.report_json = std::move(parts.report_json);
  scene.settings_json = SettingsOf(options, parts.cloud.source);
  return scene;
}

void WritePage(const Project& project, const DrawingInScene& drawing,
               const std::string& drawing_path, const PageOptions& options, PageParts parts,
               Console* console) {
  const auto shown = ShownAlignment(options.shown, drawing_path, drawing.metadata);
  ViewerScene scene = MakeViewerScene(project, drawing, options, std::move(parts), shown);
  scene.drawing = StampOf(drawing, drawing_path, PageFolder(project));
  const OutputPath path = project.DrawingPath(kViewerPage);
  WriteFileAtomically(path, [&](std::ostream& out) { WriteViewerPage(scene, out); });
  console->Say("wrote " + path.string() + ": " + std::to_string(scene.graph.links.size()) +
               " links, " + std::to_string(scene.views.size()) + " photographs, " +
               std::to_string(scene.cloud.size()) + " points, " +
               std::to_string((fs::file_size(path.string()) + 500000) / 1000000) + " MB");
}

}  // namespace limn::colmap_ext
