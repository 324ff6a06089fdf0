// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/geometry/triangle_mesh.h"

namespace limn::testing {

// The axis-parallel cube around a center: six squares, each with four vertices of its own as
// programs write them. Bit f of `leave_out` leaves out face f: -x, +x, -y, +y, -z, +z.
TriangleMesh CubeMesh(const Eigen::Vector3d& center, double half_side, unsigned leave_out = 0);

}  // namespace limn::testing
