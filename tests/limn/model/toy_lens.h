// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/LU>

#include "limn/model/lens_map.h"

namespace limn {

// stored = center + s R (virtual - center), R a turn by `angle_rad`, for stored pixels within a
// radius of the center.
class ToyLens : public LensMap {
 public:
  ToyLens(const Eigen::Vector2d& center, double scale, double angle_rad, double max_radius_px)
      : center_(center), max_radius_px_(max_radius_px) {
    stored_from_virtual_ << std::cos(angle_rad), -std::sin(angle_rad), std::sin(angle_rad),
        std::cos(angle_rad);
    stored_from_virtual_ *= scale;
  }
  std::optional<Eigen::Vector2d> VirtualFromStored(const Eigen::Vector2d& stored) const override {
    if ((stored - center_).norm() > max_radius_px_) return std::nullopt;
    return Eigen::Vector2d(center_ + stored_from_virtual_.inverse() * (stored - center_));
  }
  std::optional<Eigen::Vector2d> StoredFromVirtual(const Eigen::Vector2d& pixel) const override {
    const Eigen::Vector2d stored = center_ + stored_from_virtual_ * (pixel - center_);
    if ((stored - center_).norm() > max_radius_px_) return std::nullopt;
    return stored;
  }
  const Eigen::Matrix2d& Jacobian() const { return stored_from_virtual_; }

 private:
  Eigen::Vector2d center_;
  double max_radius_px_;
  Eigen::Matrix2d stored_from_virtual_;
};

}  // namespace limn
