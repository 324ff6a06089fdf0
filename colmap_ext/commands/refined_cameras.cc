#include "colmap_ext/commands/refined_cameras.h"

#include <filesystem>

#include "colmap_ext/workspace/model_writer.h"
#include "colmap_ext/workspace/refined_model.h"
#include "limn/io/atomic_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

std::string RefinedPath(const Project& project, const std::string& name) {
  return project.DrawingPath("refined/" + name);
}

}  // namespace

void CheckRefinedFolder(const Project& project, const RunOptions& options) {
  if (!options.pipeline.refinement.refine_poses) return;
  const std::string folder = project.DrawingPath("refined");
  std::error_code ignored;
  if (std::filesystem::equivalent(folder, project.layout().model_dir, ignored)) {
    throw OptionError("DrawingRefinement.refine_poses = 1: " + folder +
                      " would be overwritten, but is the model that is read: choose another "
                      "output_path");
  }
  if (std::filesystem::exists(RefinedPath(project, "images.bin"), ignored)) {
    throw OptionError("DrawingRefinement.refine_poses = 1: the binary model in " + folder +
                      " would hide the refined one: remove it or choose another output_path");
  }
}

const std::vector<View>& ViewsOfDrawing(const Project& project,
                                        const std::optional<RefinedCameras>& cameras) {
  return cameras ? cameras->views : project.views();
}

void WriteRefinedModel(const Project& project, const std::optional<RefinedCameras>& cameras,
                       Console* console) {
  if (!cameras) return;
  SparseModel model = ReadModel(project.layout().model_dir);
  ApplyRefinement({cameras->views, project.views(), project.view_set().hints, cameras->points},
                  &model);
  const auto write = [&](const char* name, void (*writer)(const SparseModel&, std::ostream&)) {
    WriteFileAtomically(RefinedPath(project, name), [&](std::ostream& out) { writer(model, out); });
  };
  write("cameras.txt", WriteCamerasText);
  write("images.txt", WriteImagesText);
  write("points3D.txt", WritePointsText);
  console->Say("Written: " + RefinedPath(project, "{cameras,images,points3D}.txt"));
  if (model.has_rigs) {
    console->Say(
        "WARNING: the model has rigs and frames; its images were refined each for itself, and the "
        "refined model has no rigs");
  }
}

}  // namespace limn::colmap_ext
