// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/refined_cameras.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <ostream>
#include <set>
#include <utility>

#include "colmap_ext/dense_files/products.h"
#include "colmap_ext/host/ranks.h"
#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/refined_model.h"
#include "colmap_ext/model/rig_fit.h"
#include "colmap_ext/workspace/output_check.h"
#include "colmap_ext/workspace/refined_folder.h"
#include "limn/files/atomic_file.h"
#include "limn/files/writable_folder.h"
#include "limn/util/errors.h"
#include "limn/util/median.h"
#include "limn/util/name_list.h"
#include "limn/util/number_text.h"

namespace limn::colmap_ext {
namespace {

constexpr const char* kIsOn = "refine_cameras = 1: ";
constexpr const char* kWouldReplace =
    "the result would replace the model that is read: choose another output_path";

constexpr const char* kChangesFile = "cameras.csv";

OutputPath RefinedFolder(const Project& project) { return project.DrawingPath(kRefinedFolder); }

// The largest relative change of a focal length, unless no optics changed.
void SayOptics(const RefinedCameras& cameras, const ViewSet& set, Console* console) {
  double largest = 0;
  bool changed = false;
  for (size_t v = 0; v < cameras.views.size(); ++v) {
    changed |= cameras.views[v].calibration != set.views[v].calibration;
    const double ratio = cameras.views[v].camera.MeanFocal() / set.views[v].camera.MeanFocal();
    largest = std::max(largest, std::abs(ratio - 1));
  }
  if (!changed) return console->Say("Focal lengths, principal points and distortion stay");
  console->Say("Focal lengths changed by up to " + ShortNumber(100 * largest) +
               " %, and with them principal points and distortion");
}

// Per image, what became of its camera.
std::string ChangesAsCsv(const RefinedCameras& cameras) {
  std::string csv =
      "image,moved px,edgels,residual px,certain by px,skew px,skew certain by px,misfit\n";
  for (size_t v = 0; v < cameras.views.size(); ++v) {
    const CameraChange& change = cameras.of_view[v];
    csv += cameras.views[v].name + "," + ShortNumber(change.moved_px) + "," +
           std::to_string(change.num_edgels) + "," + ShortNumber(change.residual_px) + "," +
           ShortNumber(change.certain_by_px) + "," + ShortNumber(change.skew_px) + "," +
           ShortNumber(change.skew_sigma_px) + "," + (change.is_misfit ? "1" : "0") + "\n";
  }
  return csv;
}

// "2 of 9 images <are off>: a.jpg, b.jpg. "
std::string ImagesOfPart(const std::vector<ViewId>& part, const std::vector<View>& views,
                         const std::string& what) {
  std::vector<std::string> names;
  for (const ViewId v : part) names.push_back(views[v].name);
  return std::to_string(part.size()) + " of " + std::to_string(views.size()) + " images " + what +
         ": " + ListNames(names) + ". ";
}

void SayParts(const RefinedCameras& cameras, Console* console) {
  if (!cameras.part.empty()) {
    console->Say("The cameras of " +
                 ImagesOfPart(cameras.part, cameras.views, "were off together and moved as one") +
                 "Usual causes: models that were merged wrongly, a loop that was not closed");
  }
  if (!cameras.part_left.empty()) {
    console->Say("WARNING: the cameras of " +
                 ImagesOfPart(cameras.part_left, cameras.views, "are still off together") +
                 "Lines may be drawn twice. Make the model anew, or draw the groups one by one "
                 "(--image_list_path)");
  }
}

void SayChanges(const RefinedCameras& cameras, const ViewSet& set, Console* console) {
  std::vector<double> residuals;
  std::vector<NamedNumber> misfits;
  size_t num_unseen = 0;
  for (size_t v = 0; v < cameras.views.size(); ++v) {
    const CameraChange& change = cameras.of_view[v];
    if (change.num_edgels > 0) residuals.push_back(change.residual_px);
    num_unseen += change.num_edgels == 0;
    if (change.is_misfit) misfits.push_back({set.views[v].name, change.moved_px});
  }
  console->Say("Cameras refined: their images of the scene moved by " +
               ShortNumber(cameras.median_move_px) + " px (median); edges are now within " +
               ShortNumber(Median(std::move(residuals))) + " px of their curves (median)");
  SayOptics(cameras, set, console);
  SayParts(cameras, console);
  if (num_unseen > 0) {
    console->Say("WARNING: " + std::to_string(num_unseen) + " of " +
                 std::to_string(cameras.views.size()) +
                 " images show no curve that others show: none refines their cameras");
  }
  if (misfits.empty()) return;
  std::ranges::sort(misfits, std::greater{}, &NamedNumber::number);
  console->Say("WARNING: the cameras of " + std::to_string(misfits.size()) + " of " +
               std::to_string(cameras.views.size()) + " images seem wrong and moved far: " +
               ListNumbers(misfits, "px") + "; the median is " +
               ShortNumber(cameras.median_move_px) + " px: look at their overlays");
}

// By the index of the image.
std::map<size_t, Rigid3d> HeldPoses(const ViewSet& set, const SparseModel& model) {
  std::map<size_t, Rigid3d> poses;
  for (const ViewId view : HeldViews(set.mounts)) {
    const size_t image = set.views[view].model_index;
    poses.emplace(image, model.images[image].cam_from_world);
  }
  return poses;
}

// Returns NameOfRefinedCameras.
std::string WriteAndSay(SparseModel model, const Project& project, Console* console) {
  if (!HasTextNames(model)) model.flavor = ModelFlavor::kBinary;
  const std::string name = WriteRefinedFolder(model, RefinedFolder(project));
  const std::string names = std::string("{cameras,images,points3D") +
                            (model.rigs.empty() ? "}" : ",rigs,frames}") +
                            (model.flavor == ModelFlavor::kBinary ? ".bin" : ".txt");
  console->Say("Written: " + (RefinedFolder(project) / names).string());
  return name;
}

void RemoveChanges(const Project& project) {
  const OutputPath changes = project.CurvesPath(kChangesFile);
  if (IsFileOfLimn(changes.string())) RemoveFile(changes);
}

}  // namespace

void SayCameras(const std::optional<RefinedCameras>& cameras, const ViewSet& set,
                CameraRefinement how, Console* console) {
  if (cameras) return SayChanges(*cameras, set, console);
  if (how == CameraRefinement::kAuto) {
    console->Say("Cameras are left as they are: the curves do not say that they are off");
  } else {
    console->Say(
        "WARNING: cameras stay as they are: the images show too few curves, or fewer with "
        "refined cameras");
  }
}

void ToImagePixels(const ViewSet& set, RefinedCameras* cameras) {
  for (size_t v = 0; v < cameras->of_view.size(); ++v) {
    CameraChange& change = cameras->of_view[v];
    for (double* px : {&change.moved_px, &change.residual_px, &change.certain_by_px,
                       &change.skew_px, &change.skew_sigma_px}) {
      *px /= set.views[v].scale;
    }
  }
  cameras->median_move_px /= set.TypicalScale();
}

void ToImagePixels(const ViewSet& set, RowMotion* rows) {
  for (size_t v = 0; v < rows->of_view.size(); ++v) {
    rows->of_view[v].px /= set.views[v].scale;
    rows->of_view[v].sigma_px /= set.views[v].scale;
  }
  rows->skew_px /= set.TypicalScale();
}

void ToImagePixels(const ViewSet& set, FitToGiven* fit) {
  fit->refined_px /= set.TypicalScale();
  fit->given_px /= set.TypicalScale();
}

void SayRows(const RowMotion& rows, Console* console) {
  if (!rows.IsRollingShutter()) return;
  console->Say(
      "WARNING: images seem to have been exposed row by row while the camera moved (rolling "
      "shutter): the scene moves by " +
      ShortNumber(rows.skew_px) +
      " px from the first row to the last (median), and curves may be off by half of "
      "that. Hold the camera still for each image, or use one with a global shutter");
}

void SayFitToGiven(const FitToGiven& fit, Console* console) {
  console->Say("The drawing fits the cameras as given: its curves are " +
               ShortNumber(fit.given_px) +
               " px off their edges in the images of these (median), of " +
               ShortNumber(fit.refined_px) + " px before");
}

void WarnOfDense(const Project& project, const RefinedCameras& cameras, Console* console) {
  const auto dense = LookForDenseProducts({}, {}, project.layout().dense_dir);
  if (!dense) return;
  console->Say("WARNING: dense results in " + dense->path.string() +
               " were made with the cameras as given, which are " +
               ShortNumber(cameras.median_move_px) +
               " px off (median): make them again with the refined ones, or draw for them with "
               "--output_cameras given");
}

bool ReadsRefinedFolder(const WorkspaceLayout& layout) {
  if (layout.output.drawing_dir.empty()) return false;  // in memory
  std::error_code ignored;
  return std::filesystem::equivalent(layout.output.drawing_dir / kRefinedFolder, layout.model_dir,
                                     ignored);
}

std::string WhyCamerasStay(const Job& job) {
  const PipelineOptions& options = job.options.pipeline;
  const int max_views = options.tiles.max_views;
  if (options.IsPaper()) return "Drawing.method paper draws with the cameras as given";
  if (NumRanks() > 1) return "several processes draw with the cameras as given: run one";
  if (job.scene.images().given_edges) {
    return "this needs edges of small pictures, but those of edges_path are of the images as "
           "stored: leave out edges_path";
  }
  if (job.scene.view_set().HasPanoramas()) {
    return "not with EQUIRECTANGULAR images, which the model has: name the others in "
           "image_list_path";
  }
  if (max_views > 0 && std::ssize(job.views()) > max_views) {
    return "this takes all views together, but more than Tiles.max_views = " +
           std::to_string(max_views) + " are drawn in tiles: Tiles.max_views 0 draws none";
  }
  const WorkspaceLayout& layout = job.scene.layout();
  if (layout.output.drawing_dir.empty()) return "";
  if (ReadsRefinedFolder(layout)) return kWouldReplace;
  try {
    CheckRefinedFolder(layout.output.Drawing() / kRefinedFolder, job.options.overwrite);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

CameraRefinement CameraRefinementOf(const Job& job) {
  const CameraRefinement how = job.options.pipeline.refine_cameras;
  const std::string why_not = WhyCamerasStay(job);
  if (why_not.empty()) return how;
  if (how == CameraRefinement::kOn) throw OptionError(kIsOn + why_not);
  if (how == CameraRefinement::kAuto) {
    job.console->Say("Cameras are left as they are: " + why_not);
  }
  return CameraRefinement::kOff;
}

void CheckRefinedFolder(const Project& project, const RunOptions& options) {
  CheckResultFile(project.CurvesPath(kChangesFile), options.overwrite);
  if (options.pipeline.refine_cameras != CameraRefinement::kOn) return;
  if (ReadsRefinedFolder(project.layout())) throw OptionError(kIsOn + std::string(kWouldReplace));
  CheckRefinedFolder(RefinedFolder(project), options.overwrite);
}

std::string WriteRefinedModel(const Project& project, const std::optional<RefinedCameras>& cameras,
                              Console* console) {
  if (!cameras) {
    return ReadsRefinedFolder(project.layout())
               ? NameOfRefinedCameras(RefinedFolder(project).string())
               : "";
  }
  SparseModel model = project.ReadModel();
  const std::vector<View> views = Moved(cameras->views, project.origin());
  SceneHints hints = cameras->hints;
  for (ScenePoint& point : hints.points) point.position_in_world += project.origin();
  const std::map<size_t, Rigid3d> held = HeldPoses(project.view_set(), model);
  ApplyRefinement(views, hints, &model);
  for (const auto& [image, pose] : held) model.images[image].cam_from_world = pose;
  std::set<size_t> moved;
  for (const View& view : views) {
    const size_t image = view.model_index;
    if (!held.contains(image)) moved.insert(image);
  }
  FitRigs(moved, &model);
  WriteFileAtomically(project.CurvesPath(kChangesFile),
                      [&](std::ostream& out) { out << ChangesAsCsv(*cameras); });
  return WriteAndSay(model, project, console);
}

void WriteGivenModel(const Project& project, Console* console) {
  WriteAndSay(project.ReadModel(), project, console);
  RemoveChanges(project);
}

std::string CamerasOfDrawing(const Project& project) {
  return RefinedCamerasOf(project.DrawingPath("drawing.json").string());
}

std::string CamerasOfResults(const Project& project, const std::string& sketch) {
  const std::string cameras = CamerasOfDrawing(project);
  if (!cameras.empty()) return cameras;
  return RefinedCamerasOf(project.CurvesPath(sketch + ".bin").string());
}

void RemoveOtherCameras(const Project& project, const std::string& replaced,
                        const std::string& present, Console* console) {
  if (replaced.empty() || !present.empty()) return;
  if (ReadsRefinedFolder(project.layout())) return;
  const std::string in_folder = NameOfRefinedCameras(RefinedFolder(project).string());
  if (!in_folder.empty() && in_folder != replaced) return;
  if (!RemoveRefinedFolder(RefinedFolder(project))) {
    console->Say("WARNING: " + RefinedFolder(project).string() +
                 " has files of a model that limn did not write, or that were changed since: they "
                 "do not belong to this drawing");
  }
  RemoveChanges(project);
}

}  // namespace limn::colmap_ext
