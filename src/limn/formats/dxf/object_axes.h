// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include <Eigen/Geometry>

namespace limn {

// X and y axis of the object coordinate system of a plane, by the arbitrary axis algorithm of the
// DXF reference; the rows of the matrix are the axes.
inline Eigen::Matrix3d ObjectFromWorld(const Eigen::Vector3d& normal) {
  const bool is_near_z = std::abs(normal.x()) < 1.0 / 64 && std::abs(normal.y()) < 1.0 / 64;
  const Eigen::Vector3d reference = is_near_z ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d x_axis = reference.cross(normal).normalized();
  Eigen::Matrix3d rows;
  rows << x_axis.transpose(), normal.cross(x_axis).normalized().transpose(), normal.transpose();
  return rows;
}

}  // namespace limn
