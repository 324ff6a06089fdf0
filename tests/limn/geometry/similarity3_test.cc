// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/similarity3.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

Similarity3d Example() {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 3).normalized();
  return {2.5, Eigen::AngleAxisd(0.8, axis).toRotationMatrix(), {4, -5, 6}};
}

const Eigen::Vector3d kPoint(0.3, -0.7, 1.9);

TEST(Similarity3, InverseUndoes) {
  EXPECT_LT((Inverse(Example()) * (Example() * kPoint) - kPoint).norm(), 1e-12);
}

TEST(Similarity3, ProductAppliesTheSecondFirst) {
  const Similarity3d first = {0.5, Eigen::Matrix3d::Identity(), {1, 0, 0}};
  EXPECT_LT((Example() * first * kPoint - Example() * (first * kPoint)).norm(), 1e-12);
}

TEST(Similarity3, MovedCamerasSeeMovedPointsAlike) {
  const Rigid3d cam_from_a = {Eigen::Quaterniond(Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitX())),
                              {0.1, 0.2, 3}};
  const Eigen::Vector3d in_cam = cam_from_a * kPoint;
  const Eigen::Vector3d moved = CamFromB(cam_from_a, Example()) * (Example() * kPoint);
  EXPECT_LT((moved - 2.5 * in_cam).norm(), 1e-12);
}

}  // namespace
}  // namespace limn
