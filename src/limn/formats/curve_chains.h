#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "limn/model/curve_set.h"

namespace limn {

// Vertices and edges as files have them.
struct EdgeSoup {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::pair<int, int>> edges;  // vertex indices in range
  // Per edge the curve it belongs to, or empty: unknown.
  std::vector<int> labels;
  // Edges between the same positions are one edge even if their vertices differ (mesh edges).
  bool merge_copies = false;
};

// Join edges of the same label end to end into polylines; a chain ends where the number of such
// edges at a position is not 2. Vertices at exactly the same position are one; edges of zero length
// and repetitions of the same pair of vertices are dropped. A cycle returns to its first point.
// Vertices without an edge become points. Polylines come in the order of their first edge; O(n log
// n).
CurveSet ChainEdges(const EdgeSoup& soup);

}  // namespace limn
