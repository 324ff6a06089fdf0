#pragma once

#include <cstdint>

#include "limn/topology/meetings.h"

namespace limn {

struct CoincidenceCounts {
  int64_t crossings = 0;  // of two links, in the middle of both
  int64_t passed = 0;     // nodes in the middle of another link
  int64_t nodes = 0;      // pairs of nodes
};

// Makes one node of places that coincide: where two links pass through each other, where a link
// passes through a node of others, and of two nodes, if the links part there and images show both
// (ours; algorithm/topology.md#coinciding-places). Links without vertices are left alone; the
// others need a point about every px. O(n log n) in the number of points, plus, per place, the
// views of the links.
CoincidenceCounts UniteCoincidingPlaces(const MeetingTask& task);

}  // namespace limn
