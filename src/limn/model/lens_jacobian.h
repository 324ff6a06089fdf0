#pragma once

#include <optional>

#include <Eigen/Core>

#include "limn/model/lens_map.h"

namespace limn {

// d virtual / d stored at a stored pixel, by central differences. Nothing where a neighbor cannot
// be mapped or the lens model folds.
std::optional<Eigen::Matrix2d> VirtualFromStoredJacobian(const LensMap& lens,
                                                         const Eigen::Vector2d& stored_px);

// A stored pixel in the virtual image. A null lens leaves it where it is; nothing where the lens
// cannot map.
struct LensPixel {
  Eigen::Vector2d virtual_px = Eigen::Vector2d::Zero();
  // Jacobian d stored / d virtual there.
  Eigen::Matrix2d stored_from_virtual = Eigen::Matrix2d::Identity();
};
std::optional<LensPixel> ThroughLens(const LensMap* lens, const Eigen::Vector2d& stored_px);

}  // namespace limn
