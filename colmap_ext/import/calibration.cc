#include "colmap_ext/import/calibration.h"

#include <cmath>
#include <sstream>

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace limn::colmap_ext {
namespace {

constexpr double kMaxSkewPx = 0.05;
constexpr double kMaxRotationError = 1e-3;
// Of the 3x3 part of a projection matrix whose rows have been brought to unit length.
constexpr double kMinReciprocalCondition = 1e-7;

std::string Text(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

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

Camera CameraFromCalibration(const Eigen::Matrix3d& calibration, const ImageSize& size,
                             const Place& place) {
  if (!calibration.allFinite()) place.Fail("the calibration matrix is not finite");
  const double scale = calibration(2, 2);
  if (scale == 0) place.Fail("the last element of the calibration matrix is zero");
  const Eigen::Matrix3d k = calibration / scale;
  if (!(k(0, 0) > 0 && k(1, 1) > 0)) {
    place.Fail("the calibration matrix has a focal length that is not positive");
  }
  const double tiny = 1e-9 * k(0, 0);
  if (std::abs(k(1, 0)) > tiny || std::abs(k(2, 0)) > 1e-12 || std::abs(k(2, 1)) > 1e-12) {
    place.Fail("the calibration matrix is not upper triangular");
  }
  const double skew_px = std::abs(k(0, 1)) * size.height / (2 * k(1, 1));
  if (skew_px > kMaxSkewPx) {
    place.Fail("the pixels are skewed: " + Text(skew_px) +
               " px at the border of the image; no camera of COLMAP can hold that");
  }
  Camera camera;
  camera.model = CameraModelId::kPinhole;
  camera.width = static_cast<uint64_t>(size.width);
  camera.height = static_cast<uint64_t>(size.height);
  camera.params = {k(0, 0), k(1, 1), k(0, 2), k(1, 2)};
  return camera;
}

Eigen::Quaterniond RotationFromMatrix(const Eigen::Matrix3d& matrix, const Place& place) {
  if (!matrix.allFinite()) place.Fail("the rotation is not finite");
  const double error = (matrix.transpose() * matrix - Eigen::Matrix3d::Identity()).norm();
  if (!(error <= kMaxRotationError)) {
    place.Fail("the rotation matrix is none: its columns are not orthogonal and of unit length");
  }
  if (matrix.determinant() < 0) place.Fail("the rotation matrix is none: it mirrors");
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return Eigen::Quaterniond(Eigen::Matrix3d(svd.matrixU() * svd.matrixV().transpose()))
      .normalized();
}

CalibratedPose DecomposeProjection(const Eigen::Matrix<double, 3, 4>& projection,
                                   const Place& place) {
  if (!projection.allFinite()) place.Fail("the projection matrix is not finite");
  const Eigen::Matrix3d left = projection.leftCols<3>();
  if (IsSingular(left)) {
    place.Fail("the projection matrix is singular in its first three columns: no camera");
  }
  const double scale = std::copysign(left.row(2).norm(), left.determinant());
  Eigen::Matrix3d rotation;
  CalibratedPose result;
  DecomposeRq(left / scale, &result.calibration, &rotation);
  result.calibration /= result.calibration(2, 2);
  result.cam_from_world.rotation = RotationFromMatrix(rotation, place);
  // t = K^-1 p4, and from the centre it is -R C: the same, but with this rotation.
  const Eigen::Vector3d center = -left.partialPivLu().solve(projection.col(3));
  result.cam_from_world.translation = -(result.cam_from_world.rotation * center);
  return result;
}

}  // namespace limn::colmap_ext
