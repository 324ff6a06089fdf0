// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/triangulation.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace limn {
namespace {

using Eigen::Vector3d;

TEST(TangentFromPlanes, RecoversTheLineOfBothPlanes) {
  const Vector3d tangent = Vector3d(1, 2, -0.5).normalized();
  const Vector3d point(0.1, 0.2, 4);
  const Vector3d center_b(1, 0, 0);
  const Vector3d normal_a = point.cross(tangent);
  const Vector3d normal_b = (point - center_b).cross(tangent);
  const auto found = TangentFromPlanes(normal_a, normal_b);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->norm(), 1, 1e-12);
  EXPECT_NEAR(std::abs(found->dot(tangent)), 1, 1e-12);
}

TEST(TangentFromPlanes, TangentInTheEpipolarPlaneGivesNothing) {
  EXPECT_FALSE(TangentFromPlanes({0, 1, 0}, {0, -2, 0}));
}

}  // namespace
}  // namespace limn
