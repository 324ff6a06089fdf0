// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/belief/image_evidence.h"
#include "limn/topology/topology_input.h"
#include "limn/util/parallel.h"

namespace limn {

// Per link, the number of views that see another link through it
// (algorithm/belief.md#views-through-a-link). Where the images of two links cross, a view that
// shows the farther one on both sides of the crossing looks through the nearer one, which nothing
// hides there. If it is neither a border, which would hide the farther one on one side, nor a thin
// bar, which would show its own edges, then it is not there. Only links with at least this much
// evidence contradict others. `own` of the hits must be set. Time: samples times views.
std::vector<int> CountViewsThrough(const TopologyInput& input,
                                   const std::vector<ImageEvidence>& links, double min_evidence,
                                   const RunContext& context);

}  // namespace limn
