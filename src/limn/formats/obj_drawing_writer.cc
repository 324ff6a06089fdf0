// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/obj_drawing_writer.h"

#include <ostream>
#include <vector>

#include "limn/formats/face_mesh.h"
#include "limn/formats/link_kind.h"
#include "limn/util/number_text.h"

namespace limn {
namespace {

// Elements of lines, from the numbers of the vertices of a polyline.
void PutLines(const std::vector<size_t>& vertices, const ObjOptions& options, std::ostream& out) {
  out << "l " << vertices.front();
  for (size_t i = 1; i < vertices.size(); ++i) {
    if (options.segments && i > 1) out << "\nl " << vertices[i - 1];
    out << ' ' << vertices[i];
  }
  out << '\n';
}

// Faces after `num_vertices` other vertices. Vertices and normals are counted from 1.
void PutFaces(const std::vector<DrawingFace>& faces, size_t num_vertices, const ObjOptions& options,
              std::ostream& out) {
  size_t first_vertex = num_vertices + 1, first_normal = 1;
  for (size_t id = 0; id < faces.size(); ++id) {
    const DrawingFace& face = faces[id];
    out << "o face_" << id << "\ng " << FaceSurfaceName(face.surface) << '\n';
    for (const Eigen::Vector3d& vertex : face.vertices) PutObjVector("v", vertex, options, out);
    for (const Eigen::Vector3d& normal : VertexNormals(face))
      PutObjVector("vn", normal, options, out);
    for (const auto& triangle : face.triangles) {
      out << 'f';
      for (const int corner : triangle) {
        out << ' ' << first_vertex + corner << "//" << first_normal + corner;
      }
      out << '\n';
    }
    first_vertex += face.vertices.size();
    first_normal += face.vertices.size();
  }
}

}  // namespace

void PutObjVector(const char* keyword, const Eigen::Vector3d& vector, const ObjOptions& options,
                  std::ostream& out) {
  const Eigen::Vector3d turned =
      options.y_up ? Eigen::Vector3d(vector.x(), vector.z(), -vector.y()) : vector;
  out << keyword;
  for (int axis = 0; axis < 3; ++axis) out << ' ' << NumberText(turned[axis]);
  out << '\n';
}

void WriteDrawingObj(const DrawingGraph& graph, const ObjOptions& options, LengthUnit unit,
                     std::ostream& out) {
  out << "# 3D drawing by limn: the first " << graph.nodes.size() << " vertices are its nodes\n";
  if (unit != LengthUnit::kNone) out << "# unit: " << UnitName(unit) << '\n';
  for (const DrawingNode& node : graph.nodes)
    PutObjVector("v", node.position_in_world, options, out);
  const bool has_kinds = HasKinds(graph);
  size_t num_vertices = graph.nodes.size();
  for (size_t id = 0; id < graph.links.size(); ++id) {
    const DrawingLink& link = graph.links[id];
    out << "o link_" << NumberOfLink(graph, id) << '\n';
    if (has_kinds) out << "g " << LinkKindName(link.kind) << '\n';
    if (link.kind == LinkKind::kRod) out << "# rod_radius " << NumberText(link.rod_radius) << '\n';
    std::vector<size_t> vertices = {static_cast<size_t>(link.node0) + 1};
    for (size_t i = 1; i + 1 < link.points_in_world.size(); ++i) {
      PutObjVector("v", link.points_in_world[i], options, out);
      vertices.push_back(++num_vertices);
    }
    vertices.push_back(static_cast<size_t>(link.node1) + 1);
    PutLines(vertices, options, out);
  }
  PutFaces(graph.faces, num_vertices, options, out);
}

}  // namespace limn
