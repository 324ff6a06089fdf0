#pragma once

#include <optional>

#include <Eigen/Core>

namespace limn {

// Depth along ray_a, x = depth * ray_a in frame a, of the point nearest to the ray
// origin_b + s ray_b (both given in frame a) in the least-squares sense: the point stays on ray a.
// Nothing when the rays are parallel, or meet behind either camera.
std::optional<double> DepthOnRay(const Eigen::Vector3d& ray_a, const Eigen::Vector3d& origin_b,
                                 const Eigen::Vector3d& ray_b);

// Direction of a 3D curve from its tangents in two views: the line in which the two planes through
// (camera centre, image tangent) meet (curve sketch, CVPR 2010). `normal_*` are the planes' normals in
// one common frame. Nothing when the planes coincide (tangent in the epipolar plane).
std::optional<Eigen::Vector3d> TangentFromPlanes(const Eigen::Vector3d& normal_a,
                                                 const Eigen::Vector3d& normal_b);

}  // namespace limn
