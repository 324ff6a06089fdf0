#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/refinement/edgel_matches.h"

namespace limn {

// Resamples a link to a point per px and gives it vertices with its footprint and the matched
// edgels, as RepairTopology needs them. A link that no view sees stays unchanged. Linear in its
// length, px.
void GiveVertices(const std::vector<View>& views, const LinkMatches& matches, DrawingLink* link);

}  // namespace limn
