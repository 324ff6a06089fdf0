// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/smooth_regions.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace limn {
namespace {

int CountRegions(const std::vector<int>& region) {
  return static_cast<int>(std::set<int>(region.begin(), region.end()).size());
}

// A prism of `num_sides` around z, with its two ends.
TriangleMesh Prism(int num_sides) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::vector<int>> polygons(2);
  for (int i = 0; i < num_sides; ++i) {
    const double angle = 2 * M_PI * i / num_sides;
    vertices.emplace_back(std::cos(angle), std::sin(angle), 0);
    vertices.emplace_back(std::cos(angle), std::sin(angle), 1);
    const int next = (i + 1) % num_sides;
    polygons.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    polygons[0].push_back(2 * i);
    polygons[1].push_back(2 * i + 1);
  }
  return MakeTriangleMesh(vertices, polygons);
}

TEST(SmoothRegions, OfACubeAreItsSides) {
  const TriangleMesh cube = testing::CubeMesh({1, 2, 3}, 0.5);
  const std::vector<int> region = SmoothRegions(cube, 5);
  ASSERT_EQ(region.size(), 12u);
  for (int t = 0; t < 12; ++t) EXPECT_EQ(region[t], t / 2);
}

TEST(SmoothRegions, OfAFinelyMeshedCylinderAreItsShellAndItsEnds) {
  EXPECT_EQ(CountRegions(SmoothRegions(Prism(90), 5)), 3);  // bends by 4 degrees
  EXPECT_EQ(CountRegions(SmoothRegions(Prism(60), 5)), 62);
  EXPECT_EQ(CountRegions(SmoothRegions(Prism(60), 7)), 3);
}

TEST(SmoothRegions, EndWhereThreeTrianglesMeet) {
  // A fin stands on a flat strip.
  const TriangleMesh mesh = MakeTriangleMesh(
      {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  EXPECT_EQ(CountRegions(SmoothRegions(mesh, 5)), 3);
}

}  // namespace
}  // namespace limn
