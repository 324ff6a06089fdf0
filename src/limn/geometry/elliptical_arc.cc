// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/elliptical_arc.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/SVD>

namespace limn {

EllipticalArc ImageOf(const CircularArc& arc, const Eigen::Matrix3d& plane_from_space,
                      const Eigen::Vector3d& offset) {
  constexpr double kTurn = 2 * std::numbers::pi;
  Eigen::Matrix2d half_axes;  // images of the arc's own
  half_axes.col(0) = arc.radius * (plane_from_space * arc.x_axis).head<2>();
  half_axes.col(1) = arc.radius * (plane_from_space * arc.y_axis).head<2>();
  const Eigen::JacobiSVD<Eigen::Matrix2d> svd(half_axes, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix2d u = svd.matrixU(), v = svd.matrixV();
  // v becomes a rotation: angles of the arc are then those of the ellipse plus its angle.
  if (v.determinant() < 0) {
    u.col(1) = -u.col(1);
    v.col(1) = -v.col(1);
  }
  double begin = -std::atan2(v(1, 0), v(0, 0));
  double end = begin + arc.sweep_rad;
  if (u.determinant() < 0) {
    u.col(1) = -u.col(1);
    begin = std::exchange(end, -begin);
    begin = -begin;
  }
  if (arc.IsCircle()) {
    begin = 0;
    end = kTurn;
  }
  double turns = kTurn * std::floor(begin / kTurn);
  if (begin - turns >= kTurn) turns += kTurn;  // rounded up
  EllipticalArc image;
  image.center = plane_from_space * arc.center + offset;
  image.major.head<2>() = svd.singularValues()[0] * u.col(0);
  image.major.z() = 0;
  image.minor.head<2>() = svd.singularValues()[1] * u.col(1);
  image.minor.z() = 0;
  image.begin_rad = begin - turns;
  image.end_rad = end - turns;
  return image;
}

}  // namespace limn
