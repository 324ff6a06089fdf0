#pragma once

#include "limn/pipeline/drawing_stages.h"
#include "limn/pipeline/pipeline_input.h"

namespace limn {

// The results before the refinement.
struct UnrefinedScene {
  CurvesResult image_curves;
  DrawnCurves drawn;
};

// DrawScene up to the refinement: the part that the processes of the context's team run together,
// each on the whole input. Throws what DrawScene throws.
UnrefinedScene DrawUnrefined(const PipelineInput& input, const PipelineOptions& options,
                             const RunContext& context, const StageObserver& on_stage_end);

// From photographs to the drawing (ECCV 2016): edges and fragments of every image, sketch, drawing
// graph, refinement, belief, primitives, kinds of edges. Throws OptionError, InputError, what
// `images` throws, and Cancelled.
PipelineResult DrawScene(const PipelineInput& input, const PipelineOptions& options,
                         const RunContext& context, const StageObserver& on_stage_end);

}  // namespace limn
