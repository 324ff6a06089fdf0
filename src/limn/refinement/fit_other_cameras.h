// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/model/curves_scene.h"
#include "limn/model/drawing_graph.h"
#include "limn/refinement/refinement_input.h"
#include "limn/refinement/refinement_options.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

// Two sets of cameras of the same images. Edgels have the same ids in both.
struct OtherCamerasInput {
  RefinementInput drawing;  // fits the cameras of its scene
  CurvesScene others;       // that it shall fit instead
};

struct OtherCamerasResult {
  DrawingGraph graph;
  // Median distance of the curves from their edgels in the images of the other cameras, stored px.
  double before_px = 0;
  double after_px = 0;
  StageSummary summary;
};

// Moves a drawing so that it fits other cameras, which may be wrong by some pixels
// (algorithm/cameras.md#drawings-that-fit-the-given-cameras): matches it with edgels under its own
// cameras, as RefineDrawing does, then fits it to these same edgels under the others, where no gate
// would find them. Topology, kinds and supporting views stay; sigmas and residuals are those of the
// fit. Links that too few views show follow their nodes, and free ends stay along their curve.
// Drops primitives, regularities, bodies and faces. The result passes Validate(). Throws
// OptionError and Cancelled. Time: as that of two rounds of RefineDrawing.
OtherCamerasResult FitOtherCameras(const OtherCamerasInput& input, const RefinementOptions& options,
                                   const RunContext& context);

}  // namespace limn
