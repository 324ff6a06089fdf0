#include "limn/model/lens_jacobian.h"

#include <Eigen/LU>

namespace limn {

namespace {

constexpr double kDerivativeStepPx = 0.5;

}  // namespace

std::optional<Eigen::Matrix2d> VirtualFromStoredJacobian(const LensMap& lens,
                                                         const Eigen::Vector2d& stored_px) {
  Eigen::Matrix2d jacobian;
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d step = kDerivativeStepPx * Eigen::Vector2d::Unit(axis);
    const auto ahead = lens.VirtualFromStored(stored_px + step);
    const auto behind = lens.VirtualFromStored(stored_px - step);
    if (!ahead || !behind) return std::nullopt;
    jacobian.col(axis) = (*ahead - *behind) / (2 * kDerivativeStepPx);
  }
  // A lens model that folds has no orientation to give.
  if (!(jacobian.determinant() > 0)) return std::nullopt;
  return jacobian;
}

std::optional<LensPixel> ThroughLens(const LensMap* lens, const Eigen::Vector2d& stored_px) {
  if (!lens) return LensPixel{stored_px};
  const auto virtual_px = lens->VirtualFromStored(stored_px);
  const auto jacobian = VirtualFromStoredJacobian(*lens, stored_px);
  if (!virtual_px || !jacobian) return std::nullopt;
  return LensPixel{*virtual_px, jacobian->inverse()};
}

}  // namespace limn
