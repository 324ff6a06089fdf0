// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/topology/meetings.h"

namespace limn {

// Moves free ends whose line passes through a node or crosses another link to that place; the other
// link is split there (algorithm/topology.md#nodes-and-interiors). Nodes are preferred to nearer
// interior places. The best place is chosen by geometry, then verified in the images. Link ids
// change. O(n log n) in the number of points.
void SnapEnds(const MeetingTask& task);

}  // namespace limn
