// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/refine_triangles.h"

#include <map>
#include <utility>

#include <gtest/gtest.h>

namespace limn {
namespace {

// A square of two triangles.
struct Square {
  Polyline2d vertices = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  std::vector<std::array<int, 3>> triangles = {{0, 1, 2}, {0, 2, 3}};
};

TEST(RefineTriangles, EdgesGetShort) {
  Square square;
  RefineTriangles(1, 1000, &square.vertices, &square.triangles);
  double area = 0;
  std::map<std::pair<int, int>, int> num_triangles;
  for (const auto& triangle : square.triangles) {
    const double twice = Cross(square.vertices[triangle[0]], square.vertices[triangle[1]],
                               square.vertices[triangle[2]]);
    EXPECT_GT(twice, 0);
    area += twice / 2;
    for (int s = 0; s < 3; ++s) {
      ++num_triangles[std::minmax({triangle[s], triangle[(s + 1) % 3]})];
    }
  }
  EXPECT_NEAR(area, 16, 1e-12);
  double perimeter = 0;
  for (const auto& [ends, num] : num_triangles) {
    const double length = (square.vertices[ends.first] - square.vertices[ends.second]).norm();
    EXPECT_LE(length, 1);
    EXPECT_LE(num, 2);
    if (num == 1) perimeter += length;
  }
  EXPECT_NEAR(perimeter, 16, 1e-12);  // no gaps
}

TEST(RefineTriangles, StopsAtTheNumberOfVertices) {
  Square square;
  RefineTriangles(1, 6, &square.vertices, &square.triangles);
  EXPECT_EQ(square.vertices.size(), 6u);
  const size_t num_triangles = square.triangles.size();
  RefineTriangles(100, 1000, &square.vertices, &square.triangles);
  EXPECT_EQ(square.vertices.size(), 6u);
  EXPECT_EQ(square.triangles.size(), num_triangles);
}

}  // namespace
}  // namespace limn
