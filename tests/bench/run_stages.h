// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "bench/scene.h"
#include "bench/stage_costs.h"
#include "limn/model/curve_set.h"
#include "limn/model/image.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/util/parallel.h"

namespace limn::bench {

// Hears what a stage cost and what it made.
using StageListener = std::function<void(const StageCost& cost, const CurveSet& made)>;

// The stages after the image curves, each measured on its own; what the listener does is not
// measured. They run in the order of DrawScene, for images at their own size, and results of
// earlier stages stay in memory, as they do there. Kinds are found only with photographs:
// `read_image` may be empty.
void RunStages(const Scene& scene, const std::function<Image(ViewId)>& read_image,
               const PipelineOptions& options, const RunContext& context,
               const StageListener& on_stage_end);

}  // namespace limn::bench
