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
  // The curves after a stage that has ended: the sketch, the drawing, the drawing when its links
  // are judged, and as it is written, outlines as they are seen.
  std::function<void(const std::string& stage, const CurveSet& made)> on_made;
};

// The stages of DrawScene after the image curves, with the cameras as they are. What the listener
// does is not measured; what is done between two stages counts for the later one. Kinds are found
// only with photographs: `read_image` may be empty.
void RunStages(const Scene& scene, const std::function<Image(ViewId)>& read_image,
               const PipelineOptions& options, const RunContext& context,
               const StageListener& listener);

}  // namespace limn::bench
