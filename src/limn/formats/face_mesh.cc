// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/face_mesh.h"

#include <Eigen/Geometry>

namespace limn {

std::vector<Eigen::Vector3d> VertexNormals(const DrawingFace& face) {
  std::vector<Eigen::Vector3d> normals(face.vertices.size(), Eigen::Vector3d::Zero());
  if (face.surface == FaceSurface::kPlane) {
    normals.assign(normals.size(), face.normal);
    return normals;
  }
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& triangle : face.triangles) {
    const Eigen::Vector3d& a = face.vertices[triangle[0]];
    const Eigen::Vector3d twice_area =
        (face.vertices[triangle[1]] - a).cross(face.vertices[triangle[2]] - a);
    for (const int corner : triangle) normals[corner] += twice_area;
    sum += twice_area;
  }
  if (sum.norm() == 0) sum = Eigen::Vector3d::UnitZ();
  for (Eigen::Vector3d& normal : normals) {
    normal = (normal.norm() > 0 ? normal : sum).normalized();
  }
  return normals;
}

}  // namespace limn
