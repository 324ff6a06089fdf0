// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "limn/topology/graph_editor.h"
#include "limn/topology/topology_input.h"
#include "limn/util/parallel.h"

namespace limn {

struct CircleCounts {
  int64_t added = 0;
  int64_t replaced = 0;  // links removed because they were parts of them
};

// Draws circles whole that links show in parts: arcs from several sides, or the chords of a small
// one (ours; algorithm/topology.md#whole-circles). A circle is a closed link until other links end
// on it. Links without edgels are left alone; the others need a point about every px. Time:
// candidates times points times views, plus, per circle that images show, the points of all links.
CircleCounts CompleteCircles(const TopologyInput& input, const RunContext& context,
                             GraphEditor* editor);

}  // namespace limn
