// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace limn {

// x_px = (fx X/Z + cx, fy Y/Z + cy); the center of the top-left pixel is (0, 0).
struct PinholeCamera {
  double fx = 1;
  double fy = 1;
  double cx = 0;
  double cy = 0;
  // Size of the stored image, pixels.
  int width = 0;
  int height = 0;

  double MeanFocal() const { return 0.5 * (fx + fy); }

  // Precondition: point_in_cam.z() > 0.
  Eigen::Vector2d Project(const Eigen::Vector3d& point_in_cam) const {
    const double inverse_z = 1.0 / point_in_cam.z();
    return {fx * point_in_cam.x() * inverse_z + cx, fy * point_in_cam.y() * inverse_z + cy};
  }

  // Direction of the ray through a pixel, scaled to z = 1, so that depth times it is the point.
  Eigen::Vector3d RayFromPixel(const Eigen::Vector2d& pixel) const {
    return {(pixel.x() - cx) / fx, (pixel.y() - cy) / fy, 1.0};
  }

  Eigen::Matrix3d Calibration() const {
    Eigen::Matrix3d matrix;
    matrix << fx, 0, cx, 0, fy, cy, 0, 0, 1;
    return matrix;
  }
};

}  // namespace limn
