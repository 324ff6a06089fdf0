// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "limn/topology/graph_editor.h"
#include "limn/topology/topology_input.h"
#include "limn/util/parallel.h"

namespace limn {

// Splits open links where, in several views, an image edge that no link has ends sideways at them,
// so that an edge can grow from the node (GrowEdges; ours, algorithm/topology.md#growth). Tidy
// dissolves nodes from which none grew. Returns the number of new nodes. Linear in the number of
// edgels.
int64_t SplitAtSideEdges(const TopologyInput& input, const RunContext& context,
                         GraphEditor* editor);

}  // namespace limn
