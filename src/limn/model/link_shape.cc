// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/link_shape.h"

#include <Eigen/Geometry>

namespace limn {
namespace {

// Of what is looked at of a shape: an arc turns by at most a turn, and a piece of a spline is a
// cubic.
constexpr int kStepsOfArc = 16;
constexpr int kStepsOfPiece = 4;

int NumSteps(const CurveShape& shape) {
  if (std::holds_alternative<LineSegment>(shape)) return 1;
  const auto* spline = std::get_if<CubicBSpline>(&shape);
  return spline ? kStepsOfPiece * static_cast<int>(spline->control_points.size()) : kStepsOfArc;
}

}  // namespace

bool IsAlongLink(const CurveShape& shape, const std::vector<Eigen::Vector3d>& points) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  const double reach = kMaxShapeDistance * box.diagonal().norm();
  const int num_steps = NumSteps(shape);
  for (int k = 0; k <= num_steps; ++k) {
    const Eigen::Vector3d point = PointAt(shape, static_cast<double>(k) / num_steps);
    if (!(box.exteriorDistance(point) <= reach)) return false;
  }
  return true;
}

}  // namespace limn
