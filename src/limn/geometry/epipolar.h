// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

#include <Eigen/Core>

#include "limn/geometry/pinhole_camera.h"
#include "limn/geometry/rigid3.h"

namespace limn {

// How the point at depth z on the ray of pixel (u, v) of image a projects into image b:
// x_b ~ z * infinite_homography * (u, v, 1) + epipole, where x_b.z is the depth in camera b.
struct RelativeProjection {
  Eigen::Matrix3d infinite_homography;
  Eigen::Vector3d epipole;
};

RelativeProjection MakeRelativeProjection(const PinholeCamera& camera_a,
                                          const Rigid3d& a_from_world,
                                          const PinholeCamera& camera_b,
                                          const Rigid3d& b_from_world);

// Unsigned angle between two undirected directions given as angles, in [0, pi/2].
inline double UndirectedAngle(double angle_a_rad, double angle_b_rad) {
  const double difference = angle_a_rad - angle_b_rad;
  const double half_turns = difference / M_PI;
  const auto nearest = static_cast<int64_t>(half_turns + (half_turns < 0 ? -0.5 : 0.5));
  return std::abs(difference - static_cast<double>(nearest) * M_PI);
}

}  // namespace limn
