#include "colmap_ext/verbs/view.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <nlohmann/json.hpp>

#include "colmap_ext/dense_files/dense_cloud.h"
#include "colmap_ext/dense_files/products.h"
#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/verbs/drawing_input.h"
#include "colmap_ext/verbs/selection_options.h"
#include "colmap_ext/workspace/model_folder.h"
#include "colmap_ext/workspace/output_check.h"
#include "limn/files/atomic_file.h"
#include "limn/files/json_text.h"
#include "limn/files/whole_file.h"
#include "limn/model/drawing_transform.h"
#include "limn/pictures/thumbnail.h"
#include "limn/util/errors.h"
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

Points CloudOf(const Project& project, const std::string& workspace_path,
               const ViewerOptions& options, Console* console) {
  if (options.cloud == "none") return {};
  if (options.cloud != "sparse") {
    const std::vector<fs::path> files = FindDenseCloud(workspace_path, project.layout().dense_dir);
    if (!files.empty()) {
      console->Say("cloud: " + files.front().string());
      try {
        return DensePoints(project, files, options.max_points, console);
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
  return SparsePoints(project, options.max_points);
}

std::vector<ViewerThumbnail> Thumbnails(const Project& project, int size, Console* console) {
  std::vector<ViewerThumbnail> thumbnails(project.views().size());
  ParallelFor(console->context(), "thumbnails", thumbnails.size(), [&](size_t v) {
    const Image photo = project.images().read(static_cast<ViewId>(v));
    Thumbnail made = MakeThumbnail(photo, project.views()[v], size);
    thumbnails[v] = {made.min_px, made.max_px, std::move(made.jpeg)};
  });
  ReleaseDecoded(project.view_set());
  return thumbnails;
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
  if (alignment.IsMetric()) scene->unit = alignment.Unit();
}

// Empty if none is given. Throws IoError.
std::string ReadReport(const std::string& path) {
  if (path.empty()) return "";
  std::string report = ReadWholeFile(path, kMaxJsonBytes);
  if (!report.empty() && !ParseJson(path, report).is_object()) {
    throw IoError(path, "must be a JSON object");
  }
  return report;
}

}  // namespace

void ViewVerb::AddOptions(OptionParser* parser) {
  parser->AddOption("drawing_path", &viewer_.drawing_path,
                    BasicOption("drawing to show, instead of the newer of drawing.json and "
                                "drawing-fused.json in the output folder"));
  parser->AddOption("report_path", &viewer_.report_path,
                    "JSON file with a report of the run, for the tab Report");
  parser->AddOption("cloud", &viewer_.cloud, {"auto", "sparse", "dense", "none"},
                    BasicOption("which points to show; auto = dense if there are any"));
  parser->AddOption("max_points", &viewer_.max_points,
                    BasicOption("thin the points to at most this many"));
  parser->AddOption("thumbnail_size", &viewer_.thumbnail_size,
                    BasicOption("longer side of the photographs in the page, px"));
  AddDetailOption("the page shows at first", &viewer_.detail, parser);
  parser->AddOption("aligned", &viewer_.aligned,
                    BasicOption("show the world, as drawing_aligner or --align auto found it"));
}

void ViewVerb::Prepare(RunOptions*, Console*) {
  CheckOption(viewer_.max_points >= 0 && viewer_.max_points <= 10000000, "max_points",
              viewer_.max_points, ">= 0 and <= 10000000");
  CheckOption(viewer_.thumbnail_size >= 16 && viewer_.thumbnail_size <= 4096, "thumbnail_size",
              viewer_.thumbnail_size, ">= 16 and <= 4096");
  if (!HasViewerPage()) {
    throw InputError("this limn was built without the viewer (CMake option LIMN_WITH_VIEWER)");
  }
  report_json_ = ReadReport(viewer_.report_path);
}

std::vector<std::string> ViewVerb::StartsFrom(const RunOptions&) const {
  return DrawingsToStartFrom(DrawingChoice::kNewest, viewer_.drawing_path);
}

void ViewVerb::Run(const Project& project, const RunOptions& options, Console* console) {
  CheckResultFile(project.DrawingPath(kViewerPage), options.overwrite);
  const std::string path = !viewer_.drawing_path.empty()
                               ? viewer_.drawing_path
                               : FindDrawing(project.layout().output.drawing_dir,
                                             DrawingChoice::kNewest, "drawing_path");
  const DrawingInScene drawing = ReadDrawingInScene(project, path);
  console->Say("drawing: " + path);
  std::optional<Alignment> shown;
  if (viewer_.aligned) shown = RequireAlignment(path, drawing.metadata);
  WriteViewerResult(project, options.layout.workspace_path, drawing, viewer_, report_json_, shown,
                    console);
}

ViewerScene MakeViewerScene(const Project& project, const std::string& workspace_path,
                            const DrawingInScene& drawing, const ViewerOptions& options,
                            const std::optional<Alignment>& shown, Console* console) {
  ViewerScene scene;
  const fs::path folder = fs::absolute(project.DrawingPath("").string()).lexically_normal();
  scene.title = folder.parent_path().filename().string();
  scene.detail = options.detail;
  scene.graph = Moved(drawing.graph, project.origin());
  scene.views = Moved(drawing.views, project.origin());
  scene.cloud = CloudOf(project, workspace_path, options, console);
  if (shown) MoveToWorld(*shown, &scene);
  scene.thumbnails = Thumbnails(project, options.thumbnail_size, console);
  return scene;
}

void WriteViewerResult(const Project& project, const std::string& workspace_path,
                       const DrawingInScene& drawing, const ViewerOptions& options,
                       const std::string& report_json, const std::optional<Alignment>& shown,
                       Console* console) {
  ViewerScene scene = MakeViewerScene(project, workspace_path, drawing, options, shown, console);
  scene.report_json = report_json;
  const OutputPath path = project.DrawingPath(kViewerPage);
  WriteFileAtomically(path, [&](std::ostream& out) { WriteViewerPage(scene, out); });
  console->Say("wrote " + path.string() + ": " + std::to_string(scene.graph.links.size()) +
               " links, " + std::to_string(scene.views.size()) + " photographs, " +
               std::to_string(scene.cloud.size()) + " points, " +
               std::to_string((fs::file_size(path.string()) + 500000) / 1000000) + " MB");
}

}  // namespace limn::colmap_ext
