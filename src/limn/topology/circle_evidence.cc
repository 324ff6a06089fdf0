// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/circle_evidence.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "limn/util/angles.h"

namespace limn {
namespace {

constexpr int kMinRimPoints = 12;
// Of a step: how near edgels must be, and the residual from which on they count linearly.
constexpr SupportGate kStepGates[] = {{2.5, 1.5, 35 * kDeg}, {2.5, 1.5, 35 * kDeg},
                                      {1.5, 1.5, 25 * kDeg}, {1.5, 1.5, 25 * kDeg},
                                      {1.0, 1.5, 20 * kDeg}, {1.0, 1.5, 20 * kDeg}};
constexpr double kRimRobustPx = 0.5;
// Standard deviation of center, radius and rim about the circle of the step before, px. It decides
// only what edgels leave open.
constexpr double kRimPriorPx = 3;

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// How a point of a circle moves with its center, its radius and the heights of the rim at the ends
// of both axes.
Eigen::Matrix<double, 3, 6> MotionAt(const CircularArc& circle, const Eigen::Vector3d& position) {
  const Eigen::Vector3d radial = (position - circle.center) / circle.radius;
  const Eigen::Vector3d normal = circle.Normal();
  Eigen::Matrix<double, 3, 6> motion;
  motion.leftCols<3>().setIdentity();
  motion.col(3) = radial;
  motion.col(4) = normal * circle.x_axis.dot(radial);
  motion.col(5) = normal * circle.y_axis.dot(radial);
  return motion;
}

CircularArc Moved(const CircularArc& circle, const Vector6d& by) {
  const Eigen::Vector3d normal = circle.Normal();
  CircularArc moved = circle;
  moved.center += by.head<3>();
  moved.radius += by[3];
  moved.x_axis = (circle.x_axis + by[4] / circle.radius * normal).normalized();
  moved.y_axis = circle.y_axis + by[5] / circle.radius * normal;
  moved.y_axis = (moved.y_axis - moved.x_axis.dot(moved.y_axis) * moved.x_axis).normalized();
  return moved;
}

}  // namespace

std::vector<CirclePoint> LookAlongCircle(const TopologyInput& input, const CircularArc& circle,
                                         double footprint, std::span<const ViewId> views,
                                         const SupportGate& gate) {
  const int count =
      std::max(kMinRimPoints, static_cast<int>(std::lround(2 * M_PI * circle.radius / footprint)));
  const CurveShape shape = circle;
  std::vector<CirclePoint> points(count);
  for (int k = 0; k < count; ++k) {
    CirclePoint& point = points[k];
    const double t = static_cast<double>(k) / count;
    point.position = PointAt(shape, t);
    point.tangent = DerivativeAt(shape, t).normalized();
    for (const ViewId v : views) {
      const auto edgel = input.EdgelAt(v, point.position, point.tangent, gate);
      if (edgel) point.support.push_back(*edgel);
    }
  }
  return points;
}

CircularArc FitCircleToEdgels(const TopologyInput& input, CircularArc circle, double footprint,
                              std::span<const ViewId> views) {
  for (const SupportGate& gate : kStepGates) {
    Matrix6d normal = Matrix6d::Identity() / std::pow(kRimPriorPx * footprint, 2);
    Vector6d right = Vector6d::Zero();
    for (const CirclePoint& point : LookAlongCircle(input, circle, footprint, views, gate)) {
      const Eigen::Matrix<double, 3, 6> motion = MotionAt(circle, point.position);
      for (const EdgelRef& ref : point.support) {
        const auto residual = input.Residual(ref, point.position);
        if (!residual) continue;
        const double robust = std::min(1.0, kRimRobustPx / std::abs(residual->residual_px));
        const double weight = robust / ResidualVariance(input.EdgelOf(ref));
        const Vector6d gradient = motion.transpose() * residual->gradient;
        normal += weight * gradient * gradient.transpose();
        right -= weight * residual->residual_px * gradient;
      }
    }
    const CircularArc moved = Moved(circle, normal.ldlt().solve(right));
    if (!ValidateShape(moved).empty()) return circle;
    circle = moved;
  }
  return circle;
}

}  // namespace limn
