#include "limn/geometry/epipolar.h"

#include <cmath>
#include <random>

#include <Eigen/SVD>
#include <gtest/gtest.h>

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
    std::uniform_real_distribution<double> uniform(-1, 1);
    return {uniform(random_), uniform(random_), uniform(random_)};
  }
};

TEST_F(TwoViews, FundamentalMatrixHoldsForProjections) {
  const Eigen::Matrix3d f = FundamentalMatrix(kCameraA, a_from_world_, kCameraB, b_from_world_);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d point = RandomPoint();
    const Eigen::Vector2d pixel_a = kCameraA.Project(a_from_world_ * point);
    const Eigen::Vector2d pixel_b = kCameraB.Project(b_from_world_ * point);
    const Eigen::Vector3d line = f * pixel_a.homogeneous();
    EXPECT_LT(std::abs(line.dot(pixel_b.homogeneous())) / line.head<2>().norm(), 1e-8);
  }
  const auto values = f.jacobiSvd().singularValues();
  EXPECT_LT(values[2] / values[0], 1e-12);
}

TEST_F(TwoViews, FundamentalMatrixOfOneCentreIsZero) {
  Rigid3d turned = Pose(0.3, {});
  turned.translation = -(turned.rotation * Inverse(a_from_world_).translation);
  const Eigen::Matrix3d f = FundamentalMatrix(kCameraA, a_from_world_, kCameraB, turned);
  EXPECT_LT(f.norm(), 1e-15);
}

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
