// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "limn/cameras/camera_equations.h"
#include "limn/cameras/camera_problem.h"

namespace limn {

// A similarity that moves some bodies as one, about a middle: turn, shift, logarithm of the scale.
constexpr int kPartUnknowns = 7;

// The steps of the unknowns of all bodies, a column per unknown of the part, for small motions.
// Held bodies stay.
Eigen::MatrixXd StepsOfPart(const CameraPart& part, const CameraEquations& equations,
                            const CameraState& state, const Eigen::Vector3d& middle);

// At least 2 free bodies that decrease the cost most if they move as one, while 2 others stay, by
// the linearized equations (ours; algorithm/cameras.md#parts). Empty if there are fewer than 5 free
// bodies. It climbs from parts of bodies that follow one another, and from every second, by adding
// and removing one body at a time: time O(n^3) for n bodies, and that of Linearize.
CameraPart FindPart(const CameraEquations& equations, const CameraState& state,
                    const Eigen::Vector3d& middle);

}  // namespace limn
