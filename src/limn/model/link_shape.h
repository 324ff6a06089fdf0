// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/geometry/curve_shape.h"

namespace limn {

// A link's primitive may be this many times the diagonal of the box of the link's points away from
// that box. Those farther away are no description of the link, and their numbers overflow where
// files are written.
constexpr double kMaxShapeDistance = 10;

// Whether a valid shape is so near to the points of its link. Linear time.
bool IsAlongLink(const CurveShape& shape, const std::vector<Eigen::Vector3d>& points);

}  // namespace limn
