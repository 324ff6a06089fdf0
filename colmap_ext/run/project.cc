#include "colmap_ext/run/project.h"

#include <cstdio>
#include <filesystem>
#include <system_error>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/scene_origin.h"
#include "colmap_ext/run/world_shift.h"
#include "colmap_ext/workspace/file_identity.h"
#include "colmap_ext/workspace/model_folder.h"
#include "colmap_ext/workspace/output_check.h"
#include "limn/formats/atomic_file.h"
#include "limn/sketch/view_selection.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// To be raised whenever the same file of edges gives other edges.
constexpr int kEdgeFilesVersion = 2;

std::string ImageIdentity(const ViewSet& set, ViewId view) {
  std::string identity = "image " + FileIdentity(set.image_paths[view]);
  if (const ImageWindow* window = set.Window(view)) {
    identity += "\npart " + std::to_string(window->x) + " " + std::to_string(window->y);
  }
  if (set.is_damaged[view]) identity += "\ndamaged";
  const std::string& mask_path = set.mask_paths[view];
  if (!mask_path.empty()) identity += "\nmask " + FileIdentity(mask_path);
  const PinholeCamera& camera = set.views[view].camera;
  return identity + "\nsize " + std::to_string(camera.width) + " " + std::to_string(camera.height);
}

std::string TextOf(const Eigen::Vector3d& point) {
  char text[100];
  std::snprintf(text, sizeof(text), "(%.10g, %.10g, %.10g)", point.x(), point.y(), point.z());
  return text;
}

void RemoveTemporaryFilesIn(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.path().filename().string().ends_with(kTemporarySuffix)) {
      fs::remove(entry.path(), ignored);
    }
  }
}

// Those that a killed run has left behind. Only while no other run writes here.
void RemoveTemporaryFiles(const OutputLayout& output) {
  std::error_code ignored;
  for (const char* folder : {"", "refined", "with-curves", "sparse-with-curves"}) {
    RemoveTemporaryFilesIn(output.drawing_dir / folder);
  }
  RemoveTemporaryFilesIn(output.curves_dir);
  for (const auto& entry : fs::recursive_directory_iterator(output.curves_dir, ignored)) {
    if (entry.is_directory(ignored)) RemoveTemporaryFilesIn(entry.path());
  }
}

}  // namespace

Project::Project(const RunOptions& options, Console* console)
    : layout_(ResolveLayout(options.layout)) {
  console->Say(layout_.description);
  CheckWritable(layout_.output.drawing_dir);
  CheckWritable(layout_.output.curves_dir);
  CheckLinkedCurves(layout_.output.curves_dir);
  if (!options.is_led) {
    const bool is_alone = options.shard.empty();
    lock_.emplace(layout_.output.curves_dir, is_alone ? LockMode::kExclusive : LockMode::kShared);
    if (is_alone) RemoveTemporaryFiles(layout_.output);
  }
  cache_ = std::make_shared<ResultCache>(CurvesPath("cache"));
  console->SetCache(cache_);
  SparseModel model = ReadModel(layout_.model_dir);
  if (options.pipeline.refinement.refine_poses) CheckTextNames(model);
  origin_ = SceneOrigin(model);
  MoveModel(-origin_, &model);
  view_set_ = ToViews(model, layout_.image_dir, options.view, console->context());
  for (const std::string& warning : view_set_.warnings) console->Say("WARNING: " + warning);
  console->Say(std::to_string(views().size()) + " images, " +
               std::to_string(view_set_.hints.points.size()) + " 3D points");
  if (!origin_.isZero()) {
    console->Say("Coordinates are large: working around " + TextOf(origin_) +
                 ", all files keep the model's coordinates");
  }
  CheckPanoramas(options);
  images_.read = [this](ViewId view) { return ReadViewImage(view_set_, view); };
  images_.identity = [this](ViewId view) { return ImageIdentity(view_set_, view); };
  if (!options.edges_path.empty()) UseEdges(options, console);
}

void Project::CheckPanoramas(const RunOptions& options) const {
  if (!view_set_.HasPanoramas()) return;
  if (options.pipeline.refinement.refine_poses) {
    throw OptionError(
        "DrawingRefinement.refine_poses = 1: the model has EQUIRECTANGULAR images, whose parts "
        "would move apart");
  }
  if (!options.edges_path.empty()) {
    throw OptionError("edges_path = " + options.edges_path +
                      ": the model has EQUIRECTANGULAR images, whose edges are found in parts");
  }
}

void Project::UseEdges(const RunOptions& options, Console* console) {
  edge_files_ = FindEdgeFiles(options.edges_path, view_set_);
  console->Say("Edges of all images from " + options.edges_path);
  images_.given_edges = [this, maps = options.edge_maps](ViewId view) {
    return ReadEdgeFile(edge_files_[view], view_set_, view, maps);
  };
  const std::string key = "\nedges, version " + std::to_string(kEdgeFilesVersion) + "\n" +
                          OptionsAsText(options.edge_maps);
  images_.identity = [this, key](ViewId view) {
    return ImageIdentity(view_set_, view) + key + FileIdentity(edge_files_[view]);
  };
}

std::string Project::DrawingPath(const std::string& name) const {
  return (layout_.output.drawing_dir / name).string();
}

std::string Project::CurvesPath(const std::string& name) const {
  return (layout_.output.curves_dir / name).string();
}

std::optional<Eigen::AlignedBox3d> ProjectBox(const Project& project, const RunOptions& options) {
  return Moved(BoxFromNumbers(options.box), -project.origin());
}

void CheckProjectViews(const Project& project) {
  try {
    CheckViews(project.views());
  } catch (const InputError& error) {
    std::string reason = error.what();
    for (const std::string& why : project.view_set().left_out) reason += "; " + why;
    throw InputError(reason);
  }
}

CurvesResult ExtractProjectCurves(const Project& project, const RunOptions& options,
                                  Console* console, const FragmentsObserver& on_fragments) {
  CurvesResult result = ExtractCurves(
      {project.views(), project.images(), project.cache(), std::nullopt, on_fragments},
      options.pipeline.edges, options.pipeline.linking, console->context());
  console->Report(result.summary);
  return result;
}

}  // namespace limn::colmap_ext
