// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <Eigen/Core>

namespace limn {

// Direction of a 3D curve from its tangents in two views: the intersection of the two planes
// through camera center and image tangent (curve sketch, CVPR 2010). `normal_*` are the normals of
// the planes in a common frame. Nothing if the planes coincide (tangent in the epipolar plane).
std::optional<Eigen::Vector3d> TangentFromPlanes(const Eigen::Vector3d& normal_a,
                                                 const Eigen::Vector3d& normal_b);

}  // namespace limn
