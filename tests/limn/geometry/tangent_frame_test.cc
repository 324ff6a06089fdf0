// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/tangent_frame.h"

#include <vector>

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(TangentFrame, IsRightHandedWithTheTangent) {
  const std::vector<Eigen::Vector3d> directions = {{1, 0, 0},  {0, 1, 0},     {0, 0, -1},
                                                   {1, 2, -3}, {-1e-9, 1, 0}, {1e-3, 1e-3, 5}};
  for (const Eigen::Vector3d& direction : directions) {
    const Eigen::Vector3d tangent = direction.normalized();
    Eigen::Matrix3d frame;
    frame << TangentFrame(tangent), tangent;
    EXPECT_TRUE((frame.transpose() * frame).isIdentity(1e-14)) << direction.transpose();
    EXPECT_NEAR(frame.determinant(), 1, 1e-14);
  }
}

}  // namespace
}  // namespace limn
