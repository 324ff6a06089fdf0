// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "limn/topology/joints.h"
#include "limn/util/parallel.h"

namespace limn {

struct LongEdgeCounts {
  int64_t added = 0;
  int64_t replaced = 0;  // links removed because the added ones explain their edgels
};

// Adds straight links between joints where one image curve runs from one to the other in several
// views, and removes what they replace (ours; algorithm/topology.md#long-edges). Along an edge that
// runs as the cameras move, images do not determine the depth: the sketch has pieces of it at wrong
// depths. But they do determine that of its ends, where other edges meet it. Time: see
// FindSpannedPairs; plus, per pair, its length times the views.
LongEdgeCounts AddLongEdges(const TopologyInput& input, const RunContext& context,
                            GraphEditor* editor);

}  // namespace limn
