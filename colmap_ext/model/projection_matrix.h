// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "limn/geometry/rigid3.h"

namespace limn::colmap_ext {

using ProjectionMatrix = Eigen::Matrix<double, 3, 4>;

// P = s K [R | t], decomposed for any factor s, negative ones included. P and -P project alike, so
// a camera that looks backwards cannot be distinguished from one that looks forwards.
struct DecomposedProjection {
  // Upper triangular: (0, 0) and (1, 1) are positive focal lengths, (2, 2) is 1; (0, 1) is skew.
  Eigen::Matrix3d intrinsics;
  Rigid3d cam_from_world;
};

// Throws InputError if P is not finite or its left 3 x 3 part is singular: affine cameras, ranks
// below three.
DecomposedProjection Decompose(const ProjectionMatrix& projection);

}  // namespace limn::colmap_ext
