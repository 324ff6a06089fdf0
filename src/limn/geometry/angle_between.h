// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace limn {

// The angle between two vectors other than zero, of any length, in radians in [0, pi]. Accurate
// near 0 and pi too, where an arc cosine is not.
inline double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

inline double AngleBetween2d(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

// The angle between the lines along two vectors, in [0, pi / 2]; pi / 2 if one is zero.
inline double LineAngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  if (a.isZero(0) || b.isZero(0)) return M_PI / 2;
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

}  // namespace limn
