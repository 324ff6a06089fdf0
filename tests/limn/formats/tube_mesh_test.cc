// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/tube_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace limn {
namespace {

// Of a disk of twelve corners and radius 1.
const double kDiskArea = 6 * std::sin(M_PI / 6);

double VolumeIn(const TubeMesh& tube) {
  double volume = 0;
  for (const auto& [a, b, c] : tube.triangles) {
    volume += tube.vertices[a].dot(tube.vertices[b].cross(tube.vertices[c])) / 6;
  }
  return volume;
}

// Places are told apart to a millionth.
using TubePlace = std::array<long, 3>;

TubePlace TubePlaceOf(const Eigen::Vector3d& point) {
  return {std::lround(1e6 * point.x()), std::lround(1e6 * point.y()), std::lround(1e6 * point.z())};
}

// Every edge is passed once in each direction, and all normals are on the outer side.
void ExpectClosedSurface(const TubeMesh& tube) {
  ASSERT_EQ(tube.normals.size(), tube.vertices.size());
  std::map<std::pair<TubePlace, TubePlace>, int> passed;
  for (const auto& triangle : tube.triangles) {
    const Eigen::Vector3d& a = tube.vertices[triangle[0]];
    const Eigen::Vector3d normal =
        (tube.vertices[triangle[1]] - a).cross(tube.vertices[triangle[2]] - a).normalized();
    for (int k = 0; k < 3; ++k) {
      const int from = triangle[k], to = triangle[(k + 1) % 3];
      ++passed[{TubePlaceOf(tube.vertices[from]), TubePlaceOf(tube.vertices[to])}];
      EXPECT_NEAR(tube.normals[from].norm(), 1, 1e-12);
      EXPECT_GT(tube.normals[from].dot(normal), 0.8);
    }
  }
  for (const auto& [edge, times] : passed) {
    EXPECT_EQ(times, 1);
    EXPECT_TRUE(passed.contains({edge.second, edge.first}));
  }
}

TEST(MakeTube, AStraightOneIsAPrism) {
  const TubeMesh tube = MakeTube({{1, 2, 3}, {1, 2, 3}, {2, 2, 3}, {4, 2, 3}}, false, 0.5);
  ExpectClosedSurface(tube);
  EXPECT_EQ(tube.vertices.size(), 12u * (3 + 2));
  EXPECT_EQ(tube.triangles.size(), 12u * 2 * 2 + 2 * 10);
  EXPECT_NEAR(VolumeIn(tube), 3 * 0.25 * kDiskArea, 1e-12);
  for (const Eigen::Vector3d& vertex : tube.vertices) {
    EXPECT_NEAR((vertex.tail<2>() - Eigen::Vector2d(2, 3)).norm(), 0.5, 1e-12);
  }
}

// A helix; the corners at the end are not turned against those before.
TEST(MakeTube, ABentOneDoesNotTwist) {
  Polyline3d points;
  for (int i = 0; i <= 200; ++i) {
    const double angle = 0.05 * i;
    points.emplace_back(2 * std::cos(angle), 2 * std::sin(angle), 0.3 * angle);
  }
  const TubeMesh tube = MakeTube(points, false, 0.1);
  ExpectClosedSurface(tube);
  EXPECT_NEAR(VolumeIn(tube) / (Length(points) * 0.01 * kDiskArea), 1, 1e-3);
  for (size_t v = 0; v + 12 < 12 * points.size(); ++v) {
    const Eigen::Vector3d step = points[v / 12 + 1] - points[v / 12];
    const Eigen::Vector3d turn = tube.normals[v].cross(tube.normals[v + 12]);
    EXPECT_NEAR(turn.dot(step.normalized()), 0, 1e-3);
  }
}

// A ring out of its plane: carried around it, a cross-section does not return to itself.
TEST(MakeTube, AClosedOneHasNoEnds) {
  Polyline3d points;
  for (int i = 0; i < 300; ++i) {
    const double angle = 2 * M_PI * i / 300;
    points.emplace_back(3 * std::cos(angle), 3 * std::sin(angle), std::sin(2 * angle + 0.4));
  }
  points.push_back(points.front());
  const TubeMesh tube = MakeTube(points, true, 0.2);
  ExpectClosedSurface(tube);
  EXPECT_EQ(tube.vertices.size(), 12u * 300);
  EXPECT_EQ(tube.triangles.size(), 24u * 300);
  EXPECT_NEAR(VolumeIn(tube) / (Length(points) * 0.04 * kDiskArea), 1, 1e-2);
  // Each corner goes to the next ring's corner of that number by the way of the curve.
  for (size_t v = 0; v < tube.vertices.size(); ++v) {
    const size_t next = (v + 12) % tube.vertices.size();
    EXPECT_LT((tube.vertices[next] - tube.vertices[v]).norm(), 2 * Length(points) / 300);
  }
}

TEST(MakeTube, SurvivesALineThatTurnsBack) {
  for (const bool closed : {false, true}) {
    const TubeMesh tube = MakeTube({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, closed, 0.1);
    EXPECT_TRUE(std::ranges::all_of(tube.vertices, [](const auto& v) { return v.allFinite(); }));
  }
}

}  // namespace
}  // namespace limn
