// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "limn/model/curve_set.h"

namespace limn {

// Vertices and edges as stored in files.
struct EdgeSoup {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::pair<int, int>> edges;  // vertex indices in range
  // Per edge, the curve it belongs to; empty if unknown.
  std::vector<int> labels;
  // Per edge, the radius of the rod whose center line it is on, 0 if unknown; empty if no edge has
  // one.
  std::vector<double> radii;
  // Merge edges between the same positions even if their vertices differ (mesh edges).
  bool merge_copies = false;
};

// Joins edges of the same label end to end into polylines; a chain ends where the number of such
// edges at a position is not 2. Vertices at exactly the same position are merged; edges of zero
// length and duplicate edges are dropped. A cycle returns to its first point. Vertices without an
// edge become points. Polylines are ordered by their first edge, whose radius they get. O(n log n).
CurveSet ChainEdges(const EdgeSoup& soup);

}  // namespace limn
