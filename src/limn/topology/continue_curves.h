// SPDX-License-Identifier: BSD-3-Clause
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

// Extends links from their free ends, in space, as long as enough views show edgels along the way,
// more than by chance, some of them edgels that no link has yet (ours;
// algorithm/topology.md#continuation). A link stops where it runs into another one along it, and at
// the box. Links need vertices. Time: length of what is added, px, times views.
ContinuationCounts ContinueCurves(const TopologyInput& input, const TopologyOptions& options,
                                  const RunContext& context, GraphEditor* editor);

}  // namespace limn
