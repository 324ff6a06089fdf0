#include "colmap_ext/run/refined_cameras.h"

#include <cstdio>
#include <filesystem>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/refined_model.h"
#include "colmap_ext/run/world_shift.h"
#include "colmap_ext/workspace/output_check.h"
#include "limn/formats/atomic_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

std::string RefinedPath(const Project& project, const std::string& name) {
  return project.DrawingPath("refined/" + name);
}

bool ReadsRefinedFolder(const Project& project) {
  std::error_code ignored;
  return std::filesystem::equivalent(project.DrawingPath("refined"), project.layout().model_dir,
                                     ignored);
}

}  // namespace

void CheckRefinedFolder(const Project& project, const RunOptions& options) {
  if (!options.pipeline.refinement.refine_poses) return;
  const std::string folder = project.DrawingPath("refined");
  if (ReadsRefinedFolder(project)) {
    throw OptionError("DrawingRefinement.refine_poses = 1: " + folder +
                      " would be overwritten, but is the model that is read: choose another "
                      "output_path");
  }
  for (const char* name : {"cameras.bin", "images.bin", "points3D.bin", "rigs.bin", "frames.bin",
                           "rigs.txt", "frames.txt"}) {
    const std::string path = RefinedPath(project, name);
    if (std::error_code ignored; !std::filesystem::exists(path, ignored)) continue;
    throw OptionError("DrawingRefinement.refine_poses = 1: " + path +
                      " would be read instead of what is refined, or change it: remove it or "
                      "choose another output_path");
  }
  for (const char* name : {"cameras.txt", "images.txt", "points3D.txt"}) {
    CheckResultFile(RefinedPath(project, name), options.overwrite);
  }
}

const std::vector<View>& ViewsOfDrawing(const Project& project,
                                        const std::optional<RefinedCameras>& cameras) {
  return cameras ? cameras->views : project.views();
}

void WriteRefinedModel(const Project& project, const std::optional<RefinedCameras>& cameras,
                       Console* console) {
  if (!cameras) {
    const std::string stale = RefinedPath(project, "images.txt");
    std::error_code ignored;
    if (std::filesystem::exists(stale, ignored) && !ReadsRefinedFolder(project)) {
      console->Say("WARNING: " + stale +
                   " is of an earlier run and does not belong to this drawing");
    }
    return;
  }
  SparseModel model = project.ReadModel();
  const std::vector<View> views = Moved(cameras->views, project.origin());
  std::vector<Eigen::Vector3d> points = cameras->points;
  for (Eigen::Vector3d& point : points) point += project.origin();
  ApplyRefinement({views, project.views(), project.view_set().hints, points}, &model);
  const auto write = [&](const char* name, void (*writer)(const SparseModel&, std::ostream&)) {
    WriteFileAtomically(RefinedPath(project, name), [&](std::ostream& out) { writer(model, out); });
  };
  write("cameras.txt", WriteCamerasText);
  write("images.txt", WriteImagesText);
  write("points3D.txt", WritePointsText);
  console->Say("Written: " + RefinedPath(project, "{cameras,images,points3D}.txt"));
  char moved[100];
  std::snprintf(moved, sizeof moved, "by %.2f px (median), focal lengths by up to %.3f %%",
                cameras->median_shift_px, 100 * cameras->largest_focal_change);
  console->Say(std::string("Refined cameras move their images ") + moved);
  if (model.has_rigs) {
    console->Say(
        "WARNING: the model has rigs and frames; its images were refined each for itself, and the "
        "refined model has no rigs");
  }
}

}  // namespace limn::colmap_ext
