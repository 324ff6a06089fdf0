#include "limn/formats/obj_drawing_writer.h"

#include <ostream>

#include "limn/formats/link_kind.h"
#include "limn/formats/number_text.h"

namespace limn {
namespace {

void PutVertex(std::ostream& out, const Eigen::Vector3d& point) {
  out << 'v';
  for (int axis = 0; axis < 3; ++axis) out << ' ' << NumberText(point[axis]);
  out << '\n';
}

}  // namespace

void WriteDrawingObj(const DrawingGraph& graph, std::ostream& out) {
  out << "# 3D drawing by limn: the first " << graph.nodes.size() << " vertices are its nodes\n";
  for (const DrawingNode& node : graph.nodes) PutVertex(out, node.position_in_world);
  const bool has_kinds = HasKinds(graph);
  size_t num_vertices = graph.nodes.size();
  for (size_t id = 0; id < graph.links.size(); ++id) {
    const DrawingLink& link = graph.links[id];
    out << "o link_" << id << '\n';
    if (has_kinds) out << "g " << LinkKindName(link.kind) << '\n';
    const size_t num_inner = link.points_in_world.size() - 2;
    for (size_t i = 1; i <= num_inner; ++i) PutVertex(out, link.points_in_world[i]);
    out << "l " << link.node0 + 1;
    for (size_t i = 1; i <= num_inner; ++i) out << ' ' << num_vertices + i;
    out << ' ' << link.node1 + 1 << '\n';
    num_vertices += num_inner;
  }
}

}  // namespace limn
