// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/epipolar.h"

#include <cmath>
#include <random>

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace limn {
namespace {

const PinholeCamera kCameraA = {500, 510, 320, 240, 640, 480};
const PinholeCamera kCameraB = {700, 690, 400, 300, 800, 600};

Rigid3d Pose(double angle, const Eigen::Vector3d& translation) {
  Rigid3d pose;
  pose.rotation = Eigen::AngleAxisd(angle, Eigen::Vector3d(0.2, 1, 0.1).normalized());
  pose.translation = translation;
  return pose;
}

class TwoViews : public ::testing::Test {
 protected:
  const Rigid3d a_from_world_ = Pose(0.1, {0.1, 0, 4});
  const Rigid3d b_from_world_ = Pose(-0.3, {-0.5, 0.2, 4.5});
  std::mt19937 random_{7};

  Eigen::Vector3d RandomPoint() {
    testing::UniformDistribution<double> uniform(-1, 1);
    return {uniform(random_), uniform(random_), uniform(random_)};
  }
};

TEST_F(TwoViews, RelativeProjectionFollowsTheRay) {
  const RelativeProjection relative =
      MakeRelativeProjection(kCameraA, a_from_world_, kCameraB, b_from_world_);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d point = RandomPoint();
    const Eigen::Vector3d in_a = a_from_world_ * point;
    const Eigen::Vector3d in_b = b_from_world_ * point;
    const Eigen::Vector3d homogeneous =
        in_a.z() * relative.infinite_homography * kCameraA.Project(in_a).homogeneous() +
        relative.epipole;
    EXPECT_NEAR(homogeneous.z(), in_b.z(), 1e-10);
    EXPECT_LT((homogeneous.head<2>() / homogeneous.z() - kCameraB.Project(in_b)).norm(), 1e-8);
  }
}

TEST(UndirectedAngle, IsWithinAQuarterTurnAndSymmetric) {
  EXPECT_NEAR(UndirectedAngle(0.1, 0.1 + M_PI), 0, 1e-12);
  EXPECT_NEAR(UndirectedAngle(0, M_PI / 2), M_PI / 2, 1e-12);
  EXPECT_NEAR(UndirectedAngle(3.1, -3.1), 2 * M_PI - 6.2, 1e-12);
  EXPECT_NEAR(UndirectedAngle(0.2, 0.9), UndirectedAngle(0.9, 0.2), 1e-15);
  EXPECT_NEAR(UndirectedAngle(0.2, 0.9), 0.7, 1e-12);
}

}  // namespace
}  // namespace limn
