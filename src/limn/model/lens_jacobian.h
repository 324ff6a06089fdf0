#pragma once

#include <optional>

#include <Eigen/Core>

#include "limn/model/lens_map.h"

namespace limn {

// d virtual / d stored at a stored pixel, by central differences. Nothing where a neighbor cannot
// be mapped or the lens model folds.
std::optional<Eigen::Matrix2d> VirtualFromStoredJacobian(const LensMap& lens,
                                                         const Eigen::Vector2d& stored_px);

}  // namespace limn
