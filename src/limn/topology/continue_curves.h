#pragma once

#include <cstdint>

#include "limn/topology/graph_editor.h"
#include "limn/topology/topology_input.h"
#include "limn/topology/topology_options.h"
#include "limn/util/parallel.h"

namespace limn {

struct ContinuationCounts {
  int64_t ends = 0;       // free ends that were continued
  int64_t length_px = 0;  // of what was added
};

// Follows links on from their free ends, in space, while edgels go on along them in enough views,
// beyond chance, and in some views edgels that no link has yet (ours;
// algorithm/topology.md#continuation). A link ends where it comes upon another one that runs along
// it, and does not leave the box. Links need vertices. Time: length of what is added, px, times
// views.
ContinuationCounts ContinueCurves(const TopologyInput& input, const TopologyOptions& options,
                                  const RunContext& context, GraphEditor* editor);

}  // namespace limn
