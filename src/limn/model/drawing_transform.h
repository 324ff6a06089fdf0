// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"

namespace limn {

// The drawing under x -> scale * rotation * x + translation: nodes, points and primitives are
// transformed, sigmas and radii of rods scaled, values in pixels kept. Precondition: scale > 0.
DrawingGraph Transformed(DrawingGraph graph, double scale, const Eigen::Matrix3d& rotation,
                         const Eigen::Vector3d& translation);

enum class SignedAxis { kX, kY, kZ, kMinusX, kMinusY, kMinusZ };

// The rotation that takes an axis to z, by permuting axes and changing signs only. For -y, which is
// up in most COLMAP models, it keeps x and takes z to y.
Eigen::Matrix3d ZUpFrom(SignedAxis up);

}  // namespace limn
