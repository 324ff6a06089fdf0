// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "limn/geometry/rigid3.h"

namespace limn {

// b_from_a: x_in_b = scale * rotation * x_in_a + translation, scale > 0.
struct Similarity3d {
  double scale = 1;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const {
    return scale * (rotation * point) + translation;
  }
};

inline Similarity3d operator*(const Similarity3d& c_from_b, const Similarity3d& b_from_a) {
  return {c_from_b.scale * b_from_a.scale, c_from_b.rotation * b_from_a.rotation,
          c_from_b * b_from_a.translation};
}

inline Similarity3d Inverse(const Similarity3d& b_from_a) {
  const Eigen::Matrix3d rotation = b_from_a.rotation.transpose();
  return {1 / b_from_a.scale, rotation, -(rotation * b_from_a.translation) / b_from_a.scale};
}

// The pose in b of a camera with a pose in a. Its own coordinates are scaled too, so that it sees
// the same pixels.
inline Rigid3d CamFromB(const Rigid3d& cam_from_a, const Similarity3d& b_from_a) {
  const Eigen::Quaterniond rotation =
      cam_from_a.rotation * Eigen::Quaterniond(b_from_a.rotation).conjugate();
  return {rotation, b_from_a.scale * cam_from_a.translation - rotation * b_from_a.translation};
}

}  // namespace limn
