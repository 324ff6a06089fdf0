// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/cameras/row_motion.h"
#include "limn/pipeline/drawing_stages.h"
#include "limn/pipeline/pipeline_input.h"

namespace limn {

// The results before the refinement of the drawing.
struct UnrefinedScene {
  std::vector<ImageCurves> curves;  // as the refined cameras, if there are any, see them
  DrawnCurves drawn;
  std::optional<RefinedCameras> cameras;
  RowMotion rows = {};  // CameraRefiner::Rows; of no view if nothing was measured
};

// DrawScene up to the refinement of the drawing: the part that the processes of the context's team
// run together, each on the whole input. Throws what DrawScene throws.
UnrefinedScene DrawUnrefined(const PipelineInput& input, const PipelineOptions& options,
                             const RunContext& context, const StageObserver& on_stage_end);

// From photographs to the drawing (ECCV 2016): edges and fragments of every image, cameras
// (CameraRefiner), sketch, drawing graph, refinement, belief, primitives, kinds of edges, texture.
// Throws OptionError, InputError, what `images` throws, and Cancelled.
PipelineResult DrawScene(const PipelineInput& input, const PipelineOptions& options,
                         const RunContext& context, const StageObserver& on_stage_end);

}  // namespace limn
