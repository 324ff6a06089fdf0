// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/model/drawing_graph.h"
#include "limn/topology/topology_input.h"
#include "limn/topology/topology_options.h"

namespace limn {

// Derives members, supporting views and residuals of all links from their vertices, pairs
// continuations at nodes, thins out points that nearly coincide, and drops the vertices
// (algorithm/topology.md#finishing). Linear in the number of points and edgels.
void FinishLinks(const TopologyInput& input, const TopologyOptions& options, DrawingGraph* graph);

}  // namespace limn
