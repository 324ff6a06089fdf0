#pragma once

#include <cstdint>
#include <vector>

#include "limn/topology/graph_editor.h"
#include "limn/topology/topology_options.h"

namespace limn {

// Free ends that run along another link are cut back to where they part from it; links of which
// little remains are removed. Links without vertices are left alone. Returns the number of ends
// cut. O(n log n) in the number of points.
int64_t TrimEnds(const TopologyOptions& options, GraphEditor* editor);

// Per link 0 if others run along nearly all of it (covered_share): they are the same edge. The
// shorter of two goes. Time as above.
std::vector<uint8_t> FindUncoveredLinks(const TopologyOptions& options, const DrawingGraph& graph);

}  // namespace limn
