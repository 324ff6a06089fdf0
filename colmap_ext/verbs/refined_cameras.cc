#include "colmap_ext/verbs/refined_cameras.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>

#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/mounted_images.h"
#include "colmap_ext/model/refined_model.h"
#include "colmap_ext/model/rig_fit.h"
#include "colmap_ext/workspace/output_check.h"
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

// Poses of views were refined each for itself: those of frames and sensors follow them, and give
// new ones to the images. Says how much is lost by that.
void FitRefinedRigs(const std::vector<View>& views, SparseModel* model, Console* console) {
  std::set<size_t> images;
  for (const View& view : views) images.insert(view.model_index);
  const std::set<size_t> tied = ImagesOfSharedRigs(images, *model);
  if (tied.empty()) return FitRigs(images, model);
  const SparseModel refined = *model;
  FitRigs(images, model);
  const std::vector<double> shifts = PoseShiftsPx(tied, refined, *model);
  if (shifts.empty()) {
    return console->Say(
        "Rigs are kept: how far their images are from where they were refined is not known, since "
        "they see no points");
  }
  const double median = Median(shifts);
  char text[200];
  std::snprintf(text, sizeof text,
                "their images are %.2f px (median; at most %.2f px) from where they were refined",
                median, *std::max_element(shifts.begin(), shifts.end()));
  console->Say(std::string(median > kMaxRigShiftPx ? "WARNING: rigs are kept but fit badly: "
                                                   : "Rigs are kept: ") +
               text);
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
  for (const ModelFile& file : kBinaryModelFiles) {
    const std::string path = RefinedPath(project, file.name);
    if (std::error_code ignored; !std::filesystem::exists(path, ignored)) continue;
    throw OptionError("DrawingRefinement.refine_poses = 1: " + path +
                      " would be read instead of what is refined, or change it: remove it or "
                      "choose another output_path");
  }
  for (const ModelFile& file : kTextModelFiles) {
    CheckResultFile(RefinedPath(project, file.name), options.overwrite);
  }
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
  FitRefinedRigs(views, &model, console);
  WriteModelText(model, project.DrawingPath("refined"));
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
