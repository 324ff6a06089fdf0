// SPDX-License-Identifier: BSD-3-Clause
#include "limn/plans/face_axes.h"

#include <cmath>

#include <Eigen/Geometry>

#include "limn/util/angles.h"

namespace limn {
namespace {

constexpr double kAcrossRad = 10 * kDeg;

// Nothing but rounding may decide between directions that are equally long.
constexpr double kLonger = 1 + 1e-6;

Eigen::Vector3d LongestDirection(const DrawingFace& face) {
  Eigen::Vector3d longest = face.normal.unitOrthogonal();
  double length = 0;
  for (size_t i = 0; i < face.vertices.size(); ++i) {
    for (size_t j = i + 1; j < face.vertices.size(); ++j) {
      Eigen::Vector3d way = face.vertices[j] - face.vertices[i];
      way -= way.dot(face.normal) * face.normal;
      if (way.norm() <= kLonger * length) continue;
      length = way.norm();
      longest = way / length;
    }
  }
  return longest;
}

}  // namespace

Eigen::Matrix3d AxesAlong(const DrawingFace& face, const std::optional<Eigen::Vector3d>& up) {
  const Eigen::Vector3d& normal = face.normal;
  const bool is_upright = up && normal.cross(*up).norm() > std::sin(kAcrossRad);
  const Eigen::Vector3d right =
      is_upright ? up->cross(normal).normalized().eval() : LongestDirection(face);
  Eigen::Matrix3d axes;
  axes << right.transpose(), right.cross(normal).transpose(), -normal.transpose();
  return axes;
}

}  // namespace limn
