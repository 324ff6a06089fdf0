// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "bench/scene.h"
#include "bench/stage_costs.h"
#include "limn/model/curve_set.h"
#include "limn/model/image.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/util/parallel.h"

namespace limn::bench {

struct StageListener {
  // Of every stage, in their order.
  std::function<void(const StageCost& cost)> on_stage_end;
  // What there is after a stage that has ended: the sketch, the drawing, the judged drawing, the
  // final one. The last two are with tentative links, and with rods by their outlines.
  std::function<void(const std::string& stage, const CurveSet& made)> on_made;
};

// The stages of DrawScene after the image curves, with the cameras as they are. What the listener
// does is not measured; what is done between two stages counts for the later one. `read_image` may
// be empty: kinds and texture are then left out.
void RunStages(const Scene& scene, const std::function<Image(ViewId)>& read_image,
               const PipelineOptions& options, const RunContext& context,
               const StageListener& listener);

}  // namespace limn::bench
