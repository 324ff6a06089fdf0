#pragma once

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"

namespace limn {

// The same drawing moved: x -> scale * rotation * x + translation, of nodes, points and primitives;
// sigmas are scaled. Requires scale > 0 and a rotation. What is in pixels stays.
DrawingGraph Transformed(DrawingGraph graph, double scale, const Eigen::Matrix3d& rotation,
                         const Eigen::Vector3d& translation);

enum class SignedAxis { kX, kY, kZ, kMinusX, kMinusY, kMinusZ };

// The rotation that takes an axis to z, made of zeros and ones: coordinates change places and signs
// but not values. Of -y, which is up in most models of COLMAP, it keeps x and makes z the y axis.
Eigen::Matrix3d ZUpFrom(SignedAxis up);

}  // namespace limn
