#include "colmap_ext/run/refined_cameras.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/refined_model.h"
#include "colmap_ext/run/world_shift.h"
#include "colmap_ext/workspace/output_check.h"
#include "limn/formats/atomic_file.h"
#include "limn/util/errors.h"
#include "limn/util/median.h"

namespace limn::colmap_ext {
namespace {

// Poses of images that a rigid rig does not explain.
constexpr double kMaxRigShiftPx = 1;

std::string RefinedPath(const Project& project, const std::string& name) {
  return project.DrawingPath("refined/" + name);
}

bool ReadsRefinedFolder(const Project& project) {
  std::error_code ignored;
  return std::filesystem::equivalent(project.DrawingPath("refined"), project.layout().model_dir,
                                     ignored);
}

// Poses of images were refined each for itself: those of frames and sensors follow them, and give
// new ones to the images. Says how much is lost by that.
void FitRefinedRigs(SparseModel* model, Console* console) {
  const SparseModel refined = *model;
  FitRigs(model);
  if (std::none_of(model->rigs.begin(), model->rigs.end(),
                   [](const Rig& rig) { return rig.NumCameras() > 1; })) {
    return;
  }
  const std::vector<double> shifts = PoseShiftsPx(refined, *model);
  if (shifts.empty()) return console->Say("Rigs are kept: images follow their frames");
  const double median = Median(shifts);
  char text[200];
  std::snprintf(text, sizeof text,
                "their images are %.2f px (median; at most %.2f px) from where they were refined",
                median, *std::max_element(shifts.begin(), shifts.end()));
  console->Say(std::string(median > kMaxRigShiftPx ? "WARNING: rigs are kept but fit badly: "
                                                   : "Rigs are kept: ") +
               text);
}

// Those of an earlier run with rigs, which would be read with the new model.
void RemoveRigs(const Project& project) {
  std::error_code ignored;
  for (const char* name : {"rigs.txt", "frames.txt"}) {
    std::filesystem::remove(RefinedPath(project, name), ignored);
  }
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
  for (const char* name : {"cameras.bin", "images.bin", "points3D.bin", "rigs.bin", "frames.bin"}) {
    const std::string path = RefinedPath(project, name);
    if (std::error_code ignored; !std::filesystem::exists(path, ignored)) continue;
    throw OptionError("DrawingRefinement.refine_poses = 1: " + path +
                      " would be read instead of what is refined, or change it: remove it or "
                      "choose another output_path");
  }
  for (const char* name : {"cameras.txt", "images.txt", "points3D.txt", "rigs.txt", "frames.txt"}) {
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
  FitRefinedRigs(&model, console);
  const auto write = [&](const char* name, void (*writer)(const SparseModel&, std::ostream&)) {
    WriteFileAtomically(RefinedPath(project, name), [&](std::ostream& out) { writer(model, out); });
  };
  write("cameras.txt", WriteCamerasText);
  write("images.txt", WriteImagesText);
  write("points3D.txt", WritePointsText);
  if (model.rigs.empty()) {
    RemoveRigs(project);
  } else {
    write("rigs.txt", WriteRigsText);
    write("frames.txt", WriteFramesText);
  }
  console->Say("Written: " +
               RefinedPath(project, model.rigs.empty()
                                        ? "{cameras,images,points3D}.txt"
                                        : "{cameras,images,points3D,rigs,frames}.txt"));
  char moved[100];
  std::snprintf(moved, sizeof moved, "by %.2f px (median), focal lengths by up to %.3f %%",
                cameras->median_shift_px, 100 * cameras->largest_focal_change);
  console->Say(std::string("Refined cameras move their images ") + moved);
}

}  // namespace limn::colmap_ext
