// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/refinement/control_graph.h"
#include "limn/refinement/refinement_options.h"
#include "limn/topology/topology_input.h"
#include "limn/util/parallel.h"

namespace limn {

// Gives every link new samples, with the edgels that pull at them: the best one within the gate in
// every supporting view that shows the stretch of the link around the sample
// (algorithm/refinement.md#matches). An edgel that another link fits clearly better is not used.
// Time: samples times views.
void MatchEdgels(const TopologyInput& input, const RefinementOptions& options,
                 const RunContext& context, ControlGraph* control);

}  // namespace limn
