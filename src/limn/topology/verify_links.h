#pragma once

#include <cstdint>
#include <vector>

#include "limn/model/curve3d.h"
#include "limn/model/drawing_graph.h"
#include "limn/topology/topology_input.h"
#include "limn/topology/topology_options.h"
#include "limn/util/parallel.h"

namespace limn {

// Which links to believe, 1 or 0 each. Samples of two primary views must have been merged into a
// link: curves that only agree may have been merged into another one. It must not be an occluding
// contour (occluding_contours.h). It is certain when enough
// primary views agree with it in the mean over its length (primary_views_share). Any other link
// must explain edgels that no certain link explains: it is believed when such edgels run along it
// in enough more views than any do along copies of it shifted sideways, which tell what chance does
// (own_views_share). Ours; not in the paper.
// Time: points of all links times views, ten times that for uncertain links.
std::vector<uint8_t> VerifyLinks(const TopologyInput& input, const CurveSketch& sketch,
                                 const TopologyOptions& options, const DrawingGraph& graph,
                                 const RunContext& context);

}  // namespace limn
