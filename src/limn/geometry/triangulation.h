#pragma once

#include <optional>

#include <Eigen/Core>

namespace limn {

// Direction of a 3D curve from its tangents in two views: the line in which the two planes through
// (camera center, image tangent) meet (curve sketch, CVPR 2010). `normal_*` are the planes' normals
// in one common frame. Nothing when the planes coincide (tangent in the epipolar plane).
std::optional<Eigen::Vector3d> TangentFromPlanes(const Eigen::Vector3d& normal_a,
                                                 const Eigen::Vector3d& normal_b);

}  // namespace limn
