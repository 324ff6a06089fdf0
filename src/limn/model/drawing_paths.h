#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"

namespace limn {

// Per link the number of its connected component. Components are numbered from 0 by falling length,
// those of the same length by their first link. O(links * log(links)).
std::vector<int> ComponentsOfLinks(const DrawingGraph& graph);

// A link as part of a path: walked from its first point to its last, or back.
struct PathStep {
  LinkId link = -1;
  bool reversed = false;

  auto operator<=>(const PathStep&) const = default;
};

// Links end to end: each begins at the node where the one before it ends.
using DrawingPath = std::vector<PathStep>;

// Every link in exactly one path. A path goes on where a node says that two link ends continue each
// other, and through nodes of degree 2; it ends where neither holds, or where it comes back to its
// start. In the order of their smallest link. Linear time.
std::vector<DrawingPath> PathsOf(const DrawingGraph& graph);

}  // namespace limn
