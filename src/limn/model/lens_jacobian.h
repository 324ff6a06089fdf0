// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <Eigen/Core>

#include "limn/model/lens_map.h"

namespace limn {

// A stored pixel in the virtual image. A null lens leaves it where it is; nothing where the lens
// cannot map the pixel or its neighbors, or folds.
struct LensPixel {
  Eigen::Vector2d virtual_px = Eigen::Vector2d::Zero();
  // Jacobian d stored / d virtual there, by central differences.
  Eigen::Matrix2d stored_from_virtual = Eigen::Matrix2d::Identity();
};
std::optional<LensPixel> ThroughLens(const LensMap* lens, const Eigen::Vector2d& stored_px);

}  // namespace limn
