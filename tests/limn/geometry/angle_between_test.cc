// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/angle_between.h"

#include <cmath>

#include <Eigen/Core>
#include <gtest/gtest.h>

namespace limn {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(AngleBetweenTest, LinesHaveNoDirection) {
  const Vector3d x = Vector3d::UnitX();
  const Vector3d turned(std::cos(2), std::sin(2), 0);
  EXPECT_NEAR(AngleBetween(x, turned), 2, 1e-15);
  EXPECT_NEAR(LineAngleBetween(x, turned), M_PI - 2, 1e-15);
  EXPECT_EQ(AngleBetween(x, 1.0000001 * x), 0);
  EXPECT_EQ(LineAngleBetween(x, -1.0000001 * x), 0);
}

TEST(AngleBetweenTest, LengthsDoNotMatter) {
  EXPECT_NEAR(AngleBetween(Vector3d(3, 0, 0), Vector3d(-2, 0, 2)), 0.75 * M_PI, 1e-15);
  EXPECT_NEAR(AngleBetween2d(Vector2d(3, 0), Vector2d(2, -2)), 0.25 * M_PI, 1e-15);
}

TEST(AngleBetweenTest, IsAccurateNearTheAxis) {
  const Vector3d x = Vector3d::UnitX();
  EXPECT_NEAR(AngleBetween(x, Vector3d(1, 1e-9, 0)), 1e-9, 1e-20);
  EXPECT_NEAR(LineAngleBetween(x, Vector3d(-1, 0, 1e-9)), 1e-9, 1e-20);
}

}  // namespace
}  // namespace limn
