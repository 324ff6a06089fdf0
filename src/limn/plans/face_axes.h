// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <Eigen/Core>

#include "limn/model/faces.h"

namespace limn {

// Axes of a picture along a plane face, seen from its visible side: unit rows right, down and
// forward (away from the eye). The picture is upright if `up`, a unit vector, is known and not
// across the face (within 10 degrees of its normal); else the longest direction of the face is to
// the right: that in which its vertices are farthest apart, of nearly equal ones the first.
// Quadratic in the face's vertices.
Eigen::Matrix3d AxesAlong(const DrawingFace& face, const std::optional<Eigen::Vector3d>& up);

}  // namespace limn
