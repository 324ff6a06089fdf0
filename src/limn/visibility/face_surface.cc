// SPDX-License-Identifier: BSD-3-Clause
#include "limn/visibility/face_surface.h"

namespace limn {

void AddTriangles(const std::vector<Eigen::Vector3d>& vertices,
                  const std::vector<std::array<int, 3>>& triangles, TriangleMesh* mesh) {
  const int first = static_cast<int>(mesh->vertices.size());
  mesh->vertices.insert(mesh->vertices.end(), vertices.begin(), vertices.end());
  for (const auto& [a, b, c] : triangles) {
    mesh->triangles.push_back({first + a, first + b, first + c});
  }
}

TriangleMesh MeshOf(const std::vector<DrawingFace>& faces) {
  TriangleMesh mesh;
  for (const DrawingFace& face : faces) AddTriangles(face.vertices, face.triangles, &mesh);
  return mesh;
}

}  // namespace limn
