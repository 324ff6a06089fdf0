// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "limn/geometry/curve_shape.h"

namespace limn {

// The circle that fits points best: in their plane of least squares, where the sum of the squares
// of (distance from the center)^2 - radius^2 is least (Kasa 1976). Empty for fewer than three
// points, and where they are on a line. Linear time.
std::optional<CircularArc> CircleThrough(std::span<const Eigen::Vector3d> points);

}  // namespace limn
