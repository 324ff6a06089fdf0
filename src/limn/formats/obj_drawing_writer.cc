#include "limn/formats/obj_drawing_writer.h"

#include <ostream>
#include <vector>

#include "limn/formats/link_kind.h"
#include "limn/formats/number_text.h"

namespace limn {
namespace {

void PutVertex(std::ostream& out, const Eigen::Vector3d& point) {
  out << 'v';
  for (int axis = 0; axis < 3; ++axis) out << ' ' << NumberText(point[axis]);
  out << '\n';
}

// Elements of lines, from the numbers of the vertices of a polyline.
void PutLines(const std::vector<size_t>& vertices, const ObjOptions& options, std::ostream& out) {
  out << "l " << vertices.front();
  for (size_t i = 1; i < vertices.size(); ++i) {
    if (options.segments && i > 1) out << "\nl " << vertices[i - 1];
    out << ' ' << vertices[i];
  }
  out << '\n';
}

}  // namespace

void WriteDrawingObj(const DrawingGraph& graph, const ObjOptions& options, std::ostream& out) {
  out << "# 3D drawing by limn: the first " << graph.nodes.size() << " vertices are its nodes\n";
  for (const DrawingNode& node : graph.nodes) PutVertex(out, node.position_in_world);
  const bool has_kinds = HasKinds(graph);
  size_t num_vertices = graph.nodes.size();
  for (size_t id = 0; id < graph.links.size(); ++id) {
    const DrawingLink& link = graph.links[id];
    out << "o link_" << id << '\n';
    if (has_kinds) out << "g " << LinkKindName(link.kind) << '\n';
    std::vector<size_t> vertices = {static_cast<size_t>(link.node0) + 1};
    for (size_t i = 1; i + 1 < link.points_in_world.size(); ++i) {
      PutVertex(out, link.points_in_world[i]);
      vertices.push_back(++num_vertices);
    }
    vertices.push_back(static_cast<size_t>(link.node1) + 1);
    PutLines(vertices, options, out);
  }
}

}  // namespace limn
