#include "limn/plans/mesh_of_faces.h"

namespace limn {

TriangleMesh MeshOfFaces(const std::vector<DrawingFace>& faces) {
  TriangleMesh mesh;
  for (const DrawingFace& face : faces) {
    const int first = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), face.vertices.begin(), face.vertices.end());
    for (const auto& [i, j, k] : face.triangles) {
      mesh.triangles.push_back({first + i, first + j, first + k});
    }
  }
  return mesh;
}

}  // namespace limn
