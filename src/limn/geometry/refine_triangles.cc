// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/refine_triangles.h"

#include <algorithm>
#include <utility>

namespace limn {
namespace {

// An edge of a triangle, from its corner `side` to the next.
struct TriangleSide {
  std::pair<int, int> ends;  // ascending
  int triangle = -1;
  int side = -1;
};

class TriangleRefiner {
 public:
  TriangleRefiner(Polyline2d* vertices, std::vector<std::array<int, 3>>* triangles)
      : vertices_(*vertices), triangles_(*triangles) {}

  // Whether there was an edge to split.
  bool SplitLongest(double max_length) {
    std::vector<TriangleSide> sides;
    for (int t = 0; t < std::ssize(triangles_); ++t) {
      for (int s = 0; s < 3; ++s) {
        sides.push_back({std::minmax({triangles_[t][s], triangles_[t][(s + 1) % 3]}), t, s});
      }
    }
    std::ranges::stable_sort(sides, {}, &TriangleSide::ends);
    const auto longest = std::ranges::max_element(
        sides, {}, [&](const TriangleSide& side) { return LengthOf(side); });
    if (longest == sides.end() || LengthOf(*longest) <= max_length) return false;
    const auto [a, b] = longest->ends;
    const int middle = static_cast<int>(vertices_.size());
    vertices_.emplace_back((vertices_[a] + vertices_[b]) / 2);
    for (auto side = longest; side != sides.end() && side->ends == longest->ends; ++side) {
      Split(*side, middle);
    }
    return true;
  }

 private:
  double LengthOf(const TriangleSide& side) const {
    return (vertices_[side.ends.first] - vertices_[side.ends.second]).norm();
  }
  // A triangle in two, from a place on one of its sides to the corner opposite.
  void Split(const TriangleSide& side, int middle) {
    std::array<int, 3> other = triangles_[side.triangle];
    triangles_[side.triangle][(side.side + 1) % 3] = middle;
    other[side.side] = middle;
    triangles_.push_back(other);
  }

  Polyline2d& vertices_;
  std::vector<std::array<int, 3>>& triangles_;
};

}  // namespace

void RefineTriangles(double max_length, size_t max_vertices, Polyline2d* vertices,
                     std::vector<std::array<int, 3>>* triangles) {
  TriangleRefiner refiner(vertices, triangles);
  while (vertices->size() < max_vertices && refiner.SplitLongest(max_length)) {
  }
}

}  // namespace limn
