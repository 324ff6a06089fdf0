// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/sharp_edges.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "support/meshes.h"

namespace limn {
namespace {

using testing::CubeMesh;

double TotalLength(const std::vector<Polyline3d>& curves) {
  double sum = 0;
  for (const Polyline3d& curve : curves) sum += Length(curve);
  return sum;
}

size_t NumEndPlaces(const std::vector<Polyline3d>& curves) {
  std::set<std::tuple<double, double, double>> places;
  for (const Polyline3d& curve : curves) {
    for (const Eigen::Vector3d& end : {curve.front(), curve.back()}) {
      places.emplace(end.x(), end.y(), end.z());
    }
  }
  return places.size();
}

// A strip of `num_facets` along y whose cross section turns by `total_deg` in equal bends.
TriangleMesh BentStrip(int num_facets, double total_deg) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::vector<int>> polygons;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  for (int i = 0; i <= num_facets; ++i) {
    vertices.push_back(at);
    vertices.push_back(at + 5 * Eigen::Vector3d::UnitY());
    const double angle = num_facets > 1 ? total_deg * kDeg * i / (num_facets - 1) : 0;
    at += Eigen::Vector3d(std::cos(angle), 0, std::sin(angle));
    if (i > 0) polygons.push_back({2 * i - 2, 2 * i, 2 * i + 1, 2 * i - 1});
  }
  return MakeTriangleMesh(vertices, polygons);
}

TEST(FindSharpEdges, CubeHasTwelveThatMeetAtItsCorners) {
  const std::vector<Polyline3d> edges = FindSharpEdges(CubeMesh({1, 2, 3}, 0.5), {});
  ASSERT_EQ(edges.size(), 12u);
  for (const Polyline3d& edge : edges) {
    EXPECT_EQ(edge.size(), 2u);
    EXPECT_DOUBLE_EQ(Length(edge), 1);
  }
  EXPECT_EQ(NumEndPlaces(edges), 8u);
}

TEST(FindSharpEdges, SidesBetweenFlatTrianglesAreNone) {
  TriangleMesh cube = CubeMesh({0, 0, 0}, 0.5);
  std::vector<std::vector<int>> triangles;
  for (const auto& [a, b, c] : cube.triangles) triangles.push_back({a, b, c});
  // Orientation does not matter.
  std::swap(triangles[3][0], triangles[3][1]);
  const TriangleMesh cut = MakeTriangleMesh(cube.vertices, triangles);
  ASSERT_EQ(cut.polygons.size(), 12u);
  EXPECT_EQ(FindSharpEdges(cut, {}).size(), 12u);
}

TEST(FindSharpEdges, OpenBoxGivesItsBorderToo) {
  // Without its top the cube keeps all twelve edges; without top and front one is gone.
  EXPECT_EQ(FindSharpEdges(CubeMesh({0, 0, 0}, 0.5, 0b100000), {}).size(), 12u);
  const auto edges = FindSharpEdges(CubeMesh({0, 0, 0}, 0.5, 0b100100), {});
  EXPECT_NEAR(TotalLength(edges), 11, 1e-12);
}

TEST(FindSharpEdges, BorderOfASheetIsCutAtItsCorners) {
  const TriangleMesh sheet = BentStrip(3, 0);  // 3 x 5, flat
  const auto edges = FindSharpEdges(sheet, {});
  ASSERT_EQ(edges.size(), 4u);
  EXPECT_NEAR(TotalLength(edges), 16, 1e-12);
  EXPECT_EQ(NumEndPlaces(edges), 4u);
  EXPECT_EQ(FindSharpEdges(sheet, {.min_corner_deg = 120}).size(), 1u);
}

TEST(FindSharpEdges, RoundedEdgeHasNoneBelowTheAngle) {
  // 90 degrees in 6 bends of 15, then in 2 of 45: the border alone, or two edges more.
  const auto rounded = FindSharpEdges(BentStrip(7, 90), {});
  EXPECT_EQ(rounded.size(), 4u);
  EXPECT_NEAR(TotalLength(rounded), 2 * 5 + 2 * 7, 1e-9);
  EXPECT_NEAR(TotalLength(FindSharpEdges(BentStrip(3, 90), {})), 2 * 5 + 2 * 3 + 2 * 5, 1e-9);
  EXPECT_NEAR(TotalLength(FindSharpEdges(BentStrip(3, 90), {.min_dihedral_deg = 46})), 16, 1e-9);
  // At the very angle the edge counts.
  EXPECT_NEAR(TotalLength(FindSharpEdges(BentStrip(3, 90), {.min_dihedral_deg = 45})), 26, 1e-9);
}

TEST(FindSharpEdges, WallOnAFloorIsAnEdgeEvenThoughTheFloorIsFlat) {
  const TriangleMesh mesh = MakeTriangleMesh(
      {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 1, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {0, 1, 1}},
      {{0, 1, 4, 3}, {1, 2, 5, 4}, {1, 4, 7, 6}});
  // Border of the floor 6, of the wall 3, and where they meet.
  EXPECT_NEAR(TotalLength(FindSharpEdges(mesh, {})), 10, 1e-12);
}

TEST(FindSharpEdges, RoundBorderIsOneClosedCurve) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<int> polygon;
  for (int i = 0; i < 64; ++i) {
    vertices.emplace_back(std::cos(2 * M_PI * i / 64), std::sin(2 * M_PI * i / 64), 1);
    polygon.push_back(i);
  }
  const auto edges = FindSharpEdges(MakeTriangleMesh(vertices, {polygon}), {});
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_EQ(edges[0].size(), 65u);
  EXPECT_EQ(edges[0].front(), edges[0].back());
}

TEST(SharpEdgeOptions, AreChecked) {
  EXPECT_THROW(FindSharpEdges({}, {.min_dihedral_deg = 0}), OptionError);
  EXPECT_THROW(FindSharpEdges({}, {.min_corner_deg = 181}), OptionError);
  EXPECT_TRUE(FindSharpEdges({}, {}).empty());
}

}  // namespace
}  // namespace limn
