// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/calibration.h"

#include <cmath>
#include <sstream>

#include <Eigen/LU>
#include <Eigen/SVD>

namespace limn::colmap_ext {
namespace {

constexpr double kMaxSkewPx = 0.05;
constexpr double kMaxRotationError = 1e-3;

std::string Text(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

}  // namespace

Camera CameraFromCalibration(const Eigen::Matrix3d& calibration, const ImageSize& size,
                             const FilePlace& place) {
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

Eigen::Quaterniond RotationFromMatrix(const Eigen::Matrix3d& matrix, const FilePlace& place) {
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

}  // namespace limn::colmap_ext
