// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"

namespace limn {

// Per link, the index of its connected component. Components are ordered by decreasing length, on
// ties by their first link. O(links * log(links)).
std::vector<int> ComponentsOfLinks(const DrawingGraph& graph);

// A link as part of a path: traversed from its first point to its last, or in reverse.
struct PathStep {
  LinkId link = -1;
  bool reversed = false;

  auto operator<=>(const PathStep&) const = default;
};

// Links end to end: each begins at the node where the one before it ends.
using DrawingPath = std::vector<PathStep>;

// Partitions the links into paths. A path continues where a node lists two link ends as
// continuations of each other, and through nodes of degree 2; it ends where neither holds, or where
// it returns to its start. Ordered by smallest link. Linear time.
std::vector<DrawingPath> PathsOf(const DrawingGraph& graph);

// Per link, the curve that it is a part of: the links that continue each other smoothly at nodes,
// such as the pieces of a line between its T junctions and crossings. Named by its first link.
// O(links * log(links)).
std::vector<LinkId> CurvesOf(const DrawingGraph& graph);

}  // namespace limn
