// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "limn/geometry/pinhole_camera.h"

namespace limn {

// The derivative of the image of a point in the camera, px per world unit.
inline Eigen::Matrix<double, 2, 3> PixelByPoint(const PinholeCamera& camera,
                                                const Eigen::Vector3d& point) {
  Eigen::Matrix<double, 2, 3> by_point;
  by_point << camera.fx, 0, -camera.fx * point.x() / point.z(),  //
      0, camera.fy, -camera.fy * point.y() / point.z();
  return by_point / point.z();
}

}  // namespace limn
