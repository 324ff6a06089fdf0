#include "colmap_ext/workspace/projection_matrix.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include "limn/util/errors.h"

namespace limn::colmap_ext {

DecomposedProjection Decompose(const ProjectionMatrix& projection) {
  if (!projection.allFinite()) throw InputError("the projection matrix is not finite");
  const double scale = projection.leftCols<3>().cwiseAbs().maxCoeff();
  ProjectionMatrix p = scale > 0 ? ProjectionMatrix(projection / scale) : projection;
  const Eigen::FullPivLU<Eigen::Matrix3d> left(p.leftCols<3>());
  if (!p.allFinite() || !left.isInvertible()) {
    throw InputError("the projection matrix is singular");
  }
  if (left.determinant() < 0) p = -p;
  // inverse(K R) = inverse(R) inverse(K): orthogonal times upper triangular.
  const Eigen::Matrix3d inverse = p.leftCols<3>().inverse();
  const Eigen::HouseholderQR<Eigen::Matrix3d> qr(inverse);
  const Eigen::Matrix3d triangular = qr.matrixQR().triangularView<Eigen::Upper>();
  const Eigen::Matrix3d signs = triangular.diagonal().cwiseSign().asDiagonal();
  const Eigen::Matrix3d inverse_k = signs * triangular;
  const Eigen::Matrix3d rotation = (qr.householderQ() * signs).transpose();
  DecomposedProjection result;
  result.intrinsics = inverse_k.inverse();
  result.intrinsics /= result.intrinsics(2, 2);
  result.cam_from_world.rotation = Eigen::Quaterniond(rotation).normalized();
  result.cam_from_world.translation = inverse_k * p.col(3);
  return result;
}

}  // namespace limn::colmap_ext
