// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/smooth_regions.h"

#include <span>

#include "limn/evaluation/edge_sides.h"
#include "limn/util/angles.h"
#include "limn/util/union_find.h"

namespace limn {

std::vector<int> SmoothRegions(const TriangleMesh& mesh, double max_bend_deg) {
  std::vector<std::vector<int>> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& corners : mesh.triangles) triangles.emplace_back(corners.begin(), corners.end());
  const int count = static_cast<int>(triangles.size());
  UnionFind regions(count);
  ForEachEdge(mesh.vertices, triangles, [&](std::span<const EdgeSide> sides) {
    if (sides.size() != 2 || BendAt(sides[0], sides[1]) >= max_bend_deg * kDeg) return;
    regions.Union(sides[0].polygon, sides[1].polygon);
  });
  std::vector<int> region(count, -1);
  int num_regions = 0;
  for (int t = 0; t < count; ++t) {
    const int first = regions.Find(t);
    region[t] = first == t ? num_regions++ : region[first];
  }
  return region;
}

}  // namespace limn
