// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/parabola.h"

#include <Eigen/Cholesky>

namespace limn {

Parabola FitParabola(std::span<const Eigen::Vector3d> points, std::span<const double> arcs,
                     double bend_weight) {
  // Large coordinates would cost digits.
  const Eigen::Vector3d& origin = points.front();
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d right = Eigen::Matrix3d::Zero();
  for (size_t k = 0; k < points.size(); ++k) {
    const Eigen::Vector3d powers(1, arcs[k], arcs[k] * arcs[k]);
    normal += powers * powers.transpose();
    right += powers * (points[k] - origin).transpose();
  }
  normal(2, 2) += bend_weight;
  const Eigen::Matrix3d rows = normal.ldlt().solve(right);
  return {origin + rows.row(0).transpose(), rows.row(1).transpose(), rows.row(2).transpose()};
}

}  // namespace limn
