// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/circle_through.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace limn {

std::optional<CircularArc> CircleThrough(std::span<const Eigen::Vector3d> points) {
  // Smallest variance across the principal axis, as a share of that along it.
  constexpr double kMinWidth = 1e-6;
  if (points.size() < 3) return std::nullopt;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) mean += point;
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& point : points) {
    scatter += (point - mean) * (point - mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter);
  if (!(axes.eigenvalues()[1] > kMinWidth * axes.eigenvalues()[2])) return std::nullopt;
  CircularArc circle;
  circle.x_axis = axes.eigenvectors().col(2);
  circle.y_axis = axes.eigenvectors().col(1);
  circle.sweep_rad = 2 * M_PI;
  // In the plane, relative to the mean: u^2 + v^2 = 2 a u + 2 b v + c.
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const double unit = std::sqrt(axes.eigenvalues()[2] / static_cast<double>(points.size()));
  for (const Eigen::Vector3d& point : points) {
    const double u = circle.x_axis.dot(point - mean) / unit;
    const double v = circle.y_axis.dot(point - mean) / unit;
    const Eigen::Vector3d row(2 * u, 2 * v, 1);
    normal += row * row.transpose();
    right += (u * u + v * v) * row;
  }
  const Eigen::Vector3d solution = normal.ldlt().solve(right);
  const double squared = solution[2] + solution.head<2>().squaredNorm();
  if (!(squared > 0 && std::isfinite(squared))) return std::nullopt;
  circle.center = mean + unit * (solution[0] * circle.x_axis + solution[1] * circle.y_axis);
  circle.radius = unit * std::sqrt(squared);
  return circle;
}

}  // namespace limn
