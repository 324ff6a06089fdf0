// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/link_shape.h"

#include <cmath>

#include <gtest/gtest.h>

namespace limn {
namespace {

// A quarter of a circle of radius 1 around the origin.
std::vector<Eigen::Vector3d> Quarter() {
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k <= 10; ++k) {
    points.emplace_back(std::cos(k * M_PI / 20), std::sin(k * M_PI / 20), 0);
  }
  return points;
}

TEST(IsAlongLink, ShapesOfTheLinkAreAndOthersAreNot) {
  CircularArc arc;
  arc.sweep_rad = M_PI / 2;
  EXPECT_TRUE(IsAlongLink(arc, Quarter()));
  arc.center = {1e6, 0, 0};
  EXPECT_FALSE(IsAlongLink(arc, Quarter()));
  arc.center = Eigen::Vector3d::Zero();
  arc.radius = 100;
  EXPECT_FALSE(IsAlongLink(arc, Quarter()));

  // The limit is ten diagonals from the box.
  const double reach = kMaxShapeDistance * std::sqrt(2);
  EXPECT_TRUE(IsAlongLink(LineSegment{{0, 0, 0}, {0, 0, 0.99 * reach}}, Quarter()));
  EXPECT_FALSE(IsAlongLink(LineSegment{{0, 0, 0}, {0, 0, 1.01 * reach}}, Quarter()));
}

TEST(IsAlongLink, SplinesAreLookedAtBetweenTheirEnds) {
  CubicBSpline spline;
  spline.knots = {0, 0, 0, 0, 1, 2, 2, 2, 2};
  spline.control_points = {{1, 0, 0}, {1, 0.3, 0}, {0.7, 0.7, 0}, {0.3, 1, 0}, {0, 1, 0}};
  EXPECT_TRUE(IsAlongLink(spline, Quarter()));
  spline.control_points[2] = {1e6, 1e6, 0};
  EXPECT_FALSE(IsAlongLink(spline, Quarter()));
}

}  // namespace
}  // namespace limn
