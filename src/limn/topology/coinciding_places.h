// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "limn/topology/meetings.h"

namespace limn {

// Pairs of places that became one, or parts of one.
struct CoincidenceCounts {
  int64_t crossings = 0;  // in the middle of two links
  int64_t passed = 0;     // a node, and a place in the middle of another link
  int64_t nodes = 0;
};

// Makes one node of places that coincide: where two links pass through each other, where a link
// passes through a node of others, and of two nodes, if the links part there and images show both
// (ours; algorithm/topology.md#coinciding-places). Links without vertices are left alone; the
// others need a point about every px. O(n log n) in the number of points, plus, per place, the
// views of the links.
CoincidenceCounts UniteCoincidingPlaces(const MeetingTask& task);

}  // namespace limn
