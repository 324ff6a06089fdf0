// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/circle_through.h"

#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace limn {
namespace {

using Eigen::Vector3d;

const Vector3d kCenter(100, -20, 3);
const Vector3d kX = Vector3d(1, 2, 2) / 3;
const Vector3d kY = Vector3d(2, 1, -2) / 3;

// Points of a circle of radius 4, an even number of them off its plane and its rim by turns.
std::vector<Vector3d> Arc(double sweep_rad, int count, double off = 0) {
  std::vector<Vector3d> points;
  for (int k = 0; k < count; ++k) {
    const double angle = sweep_rad * k / (count - 1);
    const double radius = 4 + (k % 2 == 0 ? off : -off);
    points.push_back(kCenter + radius * (std::cos(angle) * kX + std::sin(angle) * kY) +
                     (k % 4 < 2 ? off : -off) * kX.cross(kY));
  }
  return points;
}

TEST(CircleThroughTest, FindsTheCircleOfAnArc) {
  for (const double sweep_rad : {0.5, 2.0, 6.0}) {
    const auto circle = CircleThrough(Arc(sweep_rad, 20));
    ASSERT_TRUE(circle);
    EXPECT_TRUE(ValidateShape(*circle).empty());
    EXPECT_TRUE(circle->IsCircle());
    EXPECT_NEAR(circle->radius, 4, 1e-6);
    EXPECT_LT((circle->center - kCenter).norm(), 1e-6);
    EXPECT_NEAR(std::abs(circle->Normal().dot(kX.cross(kY))), 1, 1e-9);
  }
}

TEST(CircleThroughTest, ThreePointsDetermineIt) {
  const auto circle = CircleThrough(Arc(2, 3));
  ASSERT_TRUE(circle);
  EXPECT_LT((circle->center - kCenter).norm(), 1e-9);
}

TEST(CircleThroughTest, NoiseIsAveraged) {
  const auto circle = CircleThrough(Arc(5, 200, 0.05));
  ASSERT_TRUE(circle);
  EXPECT_NEAR(circle->radius, 4, 0.01);
  EXPECT_LT((circle->center - kCenter).norm(), 0.02);
}

TEST(CircleThroughTest, NoneThroughALineOrTwoPoints) {
  EXPECT_FALSE(CircleThrough({}));
  EXPECT_FALSE(CircleThrough(Arc(2, 2)));
  const std::vector<Vector3d> line = {kX, 2 * kX, 3 * kX, 7 * kX};
  EXPECT_FALSE(CircleThrough(line));
  const std::vector<Vector3d> one(5, kCenter);
  EXPECT_FALSE(CircleThrough(one));
}

}  // namespace
}  // namespace limn
