// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "limn/cameras/camera_rounds.h"
#include "limn/cameras/camera_scene.h"
#include "limn/cameras/camera_uncertainty.h"
#include "limn/cameras/gauge.h"
#include "limn/cameras/row_motion.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/image.h"
#include "limn/model/scene_hints.h"
#include "limn/model/view.h"
#include "limn/pipeline/extract_curves.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/util/parallel.h"

namespace limn {

struct CameraRefinementInput {
  const std::vector<View>& views;
  const SceneHints& hints;
  const ImageSource& images;
  std::optional<Eigen::AlignedBox3d> box;
  const CameraMounts& mounts;
};

// What became of the camera of a view.
struct CameraChange {
  // Motion of the image of the scene that is not common to all cameras.
  double moved_px = 0;
  // Of the edgels that curves were fitted to: number, and median distance before the last step.
  int num_edgels = 0;
  double residual_px = 0;
  // Standard deviation of the image of the scene (CertainByPx); 0 = not known.
  double certain_by_px = 0;
  // Motion of the image of the scene from its first row to its last (MeasureRowMotion), with its
  // standard deviation; 0, 0 = not known.
  double skew_px = 0;
  double skew_sigma_px = 0;
  // Moved much farther than most: it was wrong, and may still be.
  bool is_misfit = false;
};

// The refined cameras, in the frame of the given ones.
struct RefinedCameras {
  std::vector<View> views;  // as in the input, with other poses and optics
  SceneHints hints;         // the same points, elsewhere
  std::vector<CameraChange> of_view;
  double median_move_px = 0;
  // Of the cameras as they are here.
  std::optional<CameraUncertainty> uncertainty;
  // Views that were off together, as those of one of two models that were merged, and moved as one;
  // and those that still are. Empty if all moved alone.
  std::vector<ViewId> part;
  std::vector<ViewId> part_left;
};

// Refines the cameras of a scene by the curves that they see (ours; algorithm/cameras.md): first in
// small pictures, drawn until the cameras settle, then by drawings of the pictures as stored, which
// the caller makes. What the input refers to, options and context must outlive it.
class CameraRefiner {
 public:
  // `curves` are those of the pictures as stored, seen by the given views.
  CameraRefiner(const CameraRefinementInput& input, std::vector<ImageCurves> curves,
                const PipelineOptions& options, const RunContext& context);

  // Draws small pictures; the pictures as stored are fitted along the drawing of the photographs at
  // half their size. Nothing moves unless the first drawing says that cameras are off
  // (algorithm/cameras.md#whether-it-is-needed); nor if less is drawn then. Throws OptionError,
  // what the images throw, and Cancelled. Time: a large part of that of a drawing; a small one if
  // it stops after the first look.
  void RefineBySmallPictures();

  // By an unrefined drawing of the pictures as stored, made with the cameras as they are now. As
  // long as nothing has moved, kAuto moves nothing unless the edgels along the drawing say that
  // cameras are off, by the same rule, or contradict their optics. Cameras that have moved since
  // such a drawing return to the given ones if this one shows less, or little of the images.
  // Returns whether the drawing has to be made again: what wrong cameras draw is in pieces.
  bool RefineByDrawing(const DrawingGraph& graph);

  bool HaveMoved() const { return have_moved_; }

  // In the frame of the given ones. Precondition: they have moved.
  RefinedCameras Cameras() const;

  // Measured in the check of cameras that stay, or in the last fit of those that moved; of no view
  // if neither happened.
  const RowMotion& Rows() const { return rows_; }

  // Of the pictures as stored, as the cameras see them now. Valid until lenses change.
  const std::vector<ImageCurves>& Curves() { return CurvesSeenNow(scene_, context_, &stored_); }

  // Taking them ends its work.
  std::vector<ImageCurves> TakeCurves();

 private:
  struct FirstLook {
    bool are_off = false;
    bool is_part = false;  // has moved, and nothing else
    double moved_px = 0;   // of the pictures
    double seen_px = 0;    // of the images as stored, that the drawing shows
  };

  void LookAtSmallPictures();
  PictureLevel Extract(int factor);
  Image ReadShrunk(ViewId id, int factor);
  void Draw(PictureLevel* level);
  CameraRoundsResult Refine(const CameraRoundsInput& input, PictureLevel* level);
  void TakeResult(CameraRoundsResult result);
  std::vector<ViewId> ToldPart() const;
  FirstLook DrawAndRefine(const std::vector<double>& reaches, PictureLevel* level,
                          bool moves_parts = true);
  bool AreOff(const CameraRoundsResult& rounds) const;
  bool ShowsEnough(double seen_px, double given_px, const PictureLevel& level) const;
  void Settle(PictureLevel* level);
  void SettleAt(int factor);
  void RefineAsStored(const CameraRoundsInput& input);
  void ReturnToGiven();
  Eigen::Vector3d MiddleOfScene() const;
  void FixGauge();
  std::vector<View> Refined(const std::vector<View>& moved) const;

  const CameraRefinementInput input_;
  const PipelineOptions& options_;
  const RunContext& context_;
  PictureLevel stored_;
  CameraScene scene_;
  const std::vector<ViewId> held_;
  const int first_factor_;
  std::vector<std::optional<Image>> first_images_;  // while small pictures are made
  DrawingGraph graph_;                              // the last drawing
  CameraRoundsResult last_;
  RowMotion rows_;
  Gauge gauge_;
  bool have_moved_ = false;
  std::optional<MovedPart> part_;   // the last one
  std::vector<ViewId> first_part_;  // views of the first one
  int num_part_moves_ = 0;          // along drawings of the pictures as stored
  double given_px_ = 0;             // of the images, in the first drawing as stored
};

}  // namespace limn
