// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "limn/cameras/camera_scene.h"
#include "limn/cameras/camera_uncertainty.h"
#include "limn/cameras/moved_part.h"
#include "limn/cameras/row_motion.h"
#include "limn/model/drawing_graph.h"
#include "limn/refinement/refinement_options.h"
#include "limn/util/parallel.h"

namespace limn {

// What the curves say about the camera of a view.
struct CameraEvidence {
  int num_edgels = 0;      // that curves were fitted to
  double residual_px = 0;  // of these, median of the size
  // Of the image of the scene (CertainByPx); 0: held, or not known, as without edgels.
  double certain_by_px = 0;
};

struct CameraRoundsInput {
  // Drawn with the cameras of the scene as they are now.
  const DrawingGraph& graph;
  // Per round, gate and scale of the loss in multiples of those of the options; not empty.
  std::vector<double> reaches;
  // The same for rounds that follow and refine the optics, too: unless these have been refined
  // before, only if the first round says that they are off.
  std::vector<double> optics_reaches = {};
  // After the rounds; only of pictures as stored.
  bool measures_rows = false;
  // Instead of the rounds, moves a part of the cameras that is off, if there is one: lines that its
  // views draw for themselves would hold each camera alone.
  bool moves_parts = false;
  // The part that moved before the drawing was made: bodies that show more of it from the other
  // side are exchanged instead.
  std::optional<MovedPart> part_of_drawing = {};
};

struct CameraRoundsResult {
  std::vector<CameraEvidence> of_view;
  // Share of the cost that the motion of the cameras explains in the first round
  // (CameraFitResult::gain), or that of curves if it is more.
  double gain = 0;
  size_t num_links = 0;  // on which this fit found edgels
  // What has moved as one, instead of the rounds.
  std::optional<MovedPart> part;
  // After rounds with pictures as stored that were drawn since a part moved, what is off as one.
  std::vector<ViewId> part_left;
  // Whether the given optics were found to be off; false if that was not asked, or if they had been
  // refined before.
  bool optics_are_off = false;
  // After the last round, if optics might be refined and it has a solution.
  std::optional<CameraUncertainty> uncertainty;
  RowMotion rows;  // if the input asks for them; else of no view
};

// Moves the cameras of the scene, of which `level` has the pictures, so that the edges of a drawing
// lie on the edgels of all views that show them (algorithm/cameras.md). Each round matches the
// links with edgels, fits cameras and places on links together (FitCameras), then the links under
// these cameras. The lenses are taken as linear in their parameters within a round. Rounds without
// a solution change nothing. Throws Cancelled.
CameraRoundsResult RefineCamerasByDrawing(const CameraRoundsInput& input,
                                          const RefinementOptions& options,
                                          const RunContext& context, PictureLevel* level,
                                          CameraScene* scene);

}  // namespace limn
