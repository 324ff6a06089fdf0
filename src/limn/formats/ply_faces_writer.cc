// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/ply_faces_writer.h"

#include <limits>

#include "limn/formats/face_mesh.h"
#include "limn/formats/ply_output.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

void PutFaceVertices(const DrawingFace& face, std::ostream& out) {
  const std::vector<Eigen::Vector3d> normals = VertexNormals(face);
  for (size_t v = 0; v < face.vertices.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) PutLittleEndian(out, face.vertices[v][axis]);
    for (int axis = 0; axis < 3; ++axis) {
      PutLittleEndian(out, static_cast<float>(normals[v][axis]));
    }
  }
}

}  // namespace

void WriteFacesPly(const DrawingGraph& graph, LengthUnit unit, std::ostream& out) {
  size_t num_vertices = 0, num_triangles = 0;
  for (const DrawingFace& face : graph.faces) {
    num_vertices += face.vertices.size();
    num_triangles += face.triangles.size();
  }
  if (num_triangles == 0) throw InputError("the drawing has no faces");
  if (num_vertices > std::numeric_limits<int32_t>::max()) {
    throw InputError("the faces have too many vertices for a .ply file");
  }
  out << "ply\nformat binary_little_endian 1.0\n"
         "comment 3D drawing by limn: its faces, each with its id, in triangles\n"
      << UnitComment(unit) << "element vertex " << num_vertices << '\n'
      << "property double x\nproperty double y\nproperty double z\n"
         "property float nx\nproperty float ny\nproperty float nz\n"
      << "element face " << num_triangles << '\n'
      << "property list uchar int vertex_indices\nproperty int face\nend_header\n";
  for (const DrawingFace& face : graph.faces) PutFaceVertices(face, out);
  int32_t first = 0;
  for (size_t id = 0; id < graph.faces.size(); ++id) {
    for (const auto& triangle : graph.faces[id].triangles) {
      PutLittleEndian(out, uint8_t{3});
      for (const int corner : triangle) PutLittleEndian(out, first + corner);
      PutLittleEndian(out, static_cast<int32_t>(id));
    }
    first += static_cast<int32_t>(graph.faces[id].vertices.size());
  }
}

}  // namespace limn
