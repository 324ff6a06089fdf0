#pragma once

#include "limn/model/drawing_graph.h"
#include "limn/topology/topology_input.h"
#include "limn/topology/topology_options.h"

namespace limn {

// What is known of the links' vertices becomes what is known of the links: members, supporting
// views and residuals; points that lie on each other are thinned out, smooth continuations at nodes
// are paired, and the vertices are dropped. Linear in the number of points and edgels.
void FinishLinks(const TopologyInput& input, const TopologyOptions& options, DrawingGraph* graph);

}  // namespace limn
