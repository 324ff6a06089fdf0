// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/projection_matrix.h"

#include <cmath>

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

// Of the 3x3 part of a projection matrix whose rows have been brought to unit length.
constexpr double kMinReciprocalCondition = 1e-7;

bool IsSingular(Eigen::Matrix3d matrix) {
  for (int row = 0; row < 3; ++row) {
    const double norm = matrix.row(row).norm();
    if (!(norm > 0)) return true;
    matrix.row(row) /= norm;
  }
  const Eigen::Vector3d values = Eigen::JacobiSVD<Eigen::Matrix3d>(matrix).singularValues();
  return values(2) < kMinReciprocalCondition * values(0);
}

// M = K * R, from the QR decomposition of the transpose with its rows in reverse order. K has a
// positive diagonal; R is orthogonal.
void DecomposeRq(const Eigen::Matrix3d& m, Eigen::Matrix3d* k, Eigen::Matrix3d* r) {
  const Eigen::Matrix3d reversed = m.colwise().reverse().transpose();
  const Eigen::HouseholderQR<Eigen::Matrix3d> qr(reversed);
  const Eigen::Matrix3d upper = qr.matrixQR().triangularView<Eigen::Upper>();
  const Eigen::Matrix3d orthogonal = qr.householderQ();
  *k = upper.transpose().reverse();
  *r = orthogonal.transpose().colwise().reverse();
  for (int i = 0; i < 3; ++i) {
    if ((*k)(i, i) > 0) continue;
    k->col(i) *= -1;
    r->row(i) *= -1;
  }
}

}  // namespace

DecomposedProjection Decompose(const ProjectionMatrix& projection) {
  if (!projection.allFinite()) throw InputError("the projection matrix is not finite");
  const Eigen::Matrix3d left = projection.leftCols<3>();
  if (IsSingular(left)) {
    throw InputError("the projection matrix is singular in its first three columns: no camera");
  }
  const double scale = std::copysign(left.row(2).norm(), left.determinant());
  Eigen::Matrix3d rotation;
  DecomposedProjection result;
  DecomposeRq(left / scale, &result.intrinsics, &rotation);
  result.intrinsics /= result.intrinsics(2, 2);
  result.cam_from_world.rotation = Eigen::Quaterniond(rotation).normalized();
  // t = K^-1 p4, and from the center it is -R C: the same, but with this rotation.
  const Eigen::Vector3d center = -left.partialPivLu().solve(projection.col(3));
  result.cam_from_world.translation = -(result.cam_from_world.rotation * center);
  return result;
}

}  // namespace limn::colmap_ext
