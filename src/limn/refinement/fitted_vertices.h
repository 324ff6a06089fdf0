#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/refinement/edgel_matches.h"

namespace limn {

// Give a link a point every px, and vertices with its footprint and with the edgels of its matches,
// as topology edits need them. A link that no view sees stays as it is. Linear in its length, px.
void GiveVertices(const std::vector<View>& views, const LinkMatches& matches, DrawingLink* link);

}  // namespace limn
