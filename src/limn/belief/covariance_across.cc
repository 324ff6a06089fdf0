// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/covariance_across.h"

#include <cmath>

#include <Eigen/Geometry>

#include "limn/geometry/tangent_frame.h"
#include "limn/model/footprint.h"

namespace limn {

Eigen::Matrix3d CovarianceAcross(const DrawingLink& link, const Eigen::Vector3d& point_in_world,
                                 const Eigen::Vector3d& tangent, double sigma,
                                 const std::vector<View>& views) {
  const Eigen::Matrix<double, 3, 2> across = TangentFrame(tangent);
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  for (const ViewId v : link.supporting_views) {
    const auto footprint = FootprintIn(views[v], point_in_world);
    if (!footprint) continue;
    const Eigen::Vector3d ray = point_in_world - views[v].CenterInWorld();
    const Eigen::Vector3d normal = ray.cross(tangent);
    if (!(normal.norm() > std::sin(kMinAngleToCurve) * ray.norm())) continue;
    const Eigen::Vector2d seen = across.transpose() * normal.normalized() / *footprint;
    information += seen * seen.transpose();
  }
  const double sum = information.trace();
  if (!(sum > 0)) information = Eigen::Matrix2d::Identity();
  // The inverse is this over the determinant, and has its trace over it.
  Eigen::Matrix2d adjugate;
  adjugate << information(1, 1), -information(0, 1), -information(1, 0), information(0, 0);
  return across * (2 * sigma * sigma / adjugate.trace() * adjugate) * across.transpose();
}

}  // namespace limn
