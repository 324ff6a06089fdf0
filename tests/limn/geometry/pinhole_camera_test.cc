// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/pinhole_camera.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

const PinholeCamera kCamera = {500, 520, 319.5, 239.5, 640, 480};

TEST(PinholeCamera, RayThroughAPixelProjectsToIt) {
  const Eigen::Vector2d pixel(12.25, 470.5);
  const Eigen::Vector3d ray = kCamera.RayFromPixel(pixel);
  EXPECT_EQ(ray.z(), 1);
  EXPECT_LT((kCamera.Project(3.5 * ray) - pixel).norm(), 1e-10);
}

TEST(PinholeCamera, CalibrationIsTheSameMap) {
  const Eigen::Vector3d point(0.3, -0.2, 2.5);
  const Eigen::Vector3d homogeneous = kCamera.Calibration() * point;
  EXPECT_LT((kCamera.Project(point) - homogeneous.head<2>() / homogeneous.z()).norm(), 1e-10);
  EXPECT_EQ(kCamera.MeanFocal(), 510);
}

}  // namespace
}  // namespace limn
