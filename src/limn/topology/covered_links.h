// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "limn/topology/graph_editor.h"
#include "limn/topology/topology_options.h"

namespace limn {

// Cuts free ends that run along another link back to where they part from it, and removes links of
// which little remains (algorithm/refinement.md#repairs-between-fits). Links without vertices are
// left alone. Returns the number of ends cut. O(n log n) in the number of points.
int64_t TrimEnds(const TopologyOptions& options, GraphEditor* editor);

// Per link, 0 if other links run along covered_share of it or more, so that it shows the same edge
// as they do, else 1. Of two such links the shorter one goes (algorithm/topology.md#covered-links).
// Time as above.
std::vector<uint8_t> FindUncoveredLinks(const TopologyOptions& options, const DrawingGraph& graph);

}  // namespace limn
