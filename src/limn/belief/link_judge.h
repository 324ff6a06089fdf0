// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "limn/belief/belief_options.h"
#include "limn/belief/image_evidence.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/curves_scene.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/support/edgel_index.h"
#include "limn/topology/topology_options.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

// The supporting views of the links are ids of the scene's views. The graph passes Validate().
struct BeliefInput {
  CurvesScene scene;
  const DrawingGraph& graph;
  // Per link, whether it could be fitted to the images. Empty: unknown, treated as if all were.
  const std::vector<uint8_t>& fitted;
  // An edgel shows a link within it: that of the refinement.
  SupportGate gate;
};

struct BeliefResult {
  DrawingGraph graph;
  StageSummary summary;
};

// Marks the links of a finished drawing that the images do not support as tentative, with a reason
// (ours; algorithm/belief.md). A link is doubted because too few views show it to be fitted;
// because no more views show it than would by accident, with less evidence required of links that
// meet others or are well located; because views see other links through it; because better links
// explain its edgels; because its edgels stand still; or because its views are too near to each
// other to measure its depth. Links tell their evidence. Marks of earlier runs are replaced.
// Nothing is removed, so the result passes Validate(). Throws OptionError and Cancelled. Time:
// length of all links in px times views, plus, per link, the square of the number of supporting
// views.
BeliefResult JudgeLinks(const BeliefInput& input, const BeliefOptions& options,
                        const TopologyOptions& topology, const RunContext& context);

}  // namespace limn
