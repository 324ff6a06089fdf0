// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/lens_jacobian.h"

#include <Eigen/LU>

namespace limn {

namespace {

constexpr double kDerivativeStepPx = 0.5;

// By central differences of the direction that needs no iteration.
std::optional<Eigen::Matrix2d> StoredFromVirtualJacobian(const LensMap& lens,
                                                         const Eigen::Vector2d& virtual_px) {
  Eigen::Matrix2d jacobian;
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d step = kDerivativeStepPx * Eigen::Vector2d::Unit(axis);
    const auto ahead = lens.StoredFromVirtual(virtual_px + step);
    const auto behind = lens.StoredFromVirtual(virtual_px - step);
    if (!ahead || !behind) return std::nullopt;
    jacobian.col(axis) = (*ahead - *behind) / (2 * kDerivativeStepPx);
  }
  // A lens model that folds has no orientation to give.
  if (!(jacobian.determinant() > 0)) return std::nullopt;
  return jacobian;
}

}  // namespace

std::optional<LensPixel> ThroughLens(const LensMap* lens, const Eigen::Vector2d& stored_px) {
  if (!lens) return LensPixel{stored_px};
  const auto virtual_px = lens->VirtualFromStored(stored_px);
  if (!virtual_px) return std::nullopt;
  const auto jacobian = StoredFromVirtualJacobian(*lens, *virtual_px);
  if (!jacobian) return std::nullopt;
  return LensPixel{*virtual_px, *jacobian};
}

}  // namespace limn
