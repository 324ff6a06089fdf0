#pragma once

#include <cstdint>

#include "limn/drawing/draft.h"

namespace limn {

// Free the ends of links that leave a node together with another link, turning away from it by less
// than min_junction_angle_deg: merging leaves such forks where two strands of one edge, or two
// parallel edges, part slowly. Edges do not meet so. Of such a pair the link stays that goes on
// best into a third link of the node, or else the longer one. Returns the number of ends freed.
// Linear in the number of ends, quadratic in those of one node.
int64_t CutForks(const DrawingOptions& options, Draft* draft);

}  // namespace limn
