// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/ply_drawing_writer.h"

#include <algorithm>

#include "limn/formats/colors.h"
#include "limn/formats/link_kind.h"
#include "limn/formats/ply_output.h"
#include "limn/model/drawing_paths.h"

namespace limn {
namespace {

void PutVertex(std::ostream& out, const Eigen::Vector3d& point, const Color& color, double sigma) {
  for (int axis = 0; axis < 3; ++axis) PutLittleEndian(out, point[axis]);
  PutColor(out, color);
  PutLittleEndian(out, sigma);
}

size_t NumInnerPoints(const DrawingLink& link) { return link.points_in_world.size() - 2; }

// The sigma of a node is that of the first link end there.
double SigmaOfNode(const DrawingGraph& graph, const DrawingNode& node) {
  const LinkEnd end = node.incident.front();
  const std::vector<double>& sigma = graph.links[end.link].sigma;
  return end.end == 0 ? sigma.front() : sigma.back();
}

void PutVertices(const DrawingGraph& graph, std::ostream& out) {
  constexpr Color kWhite = {255, 255, 255};
  for (const DrawingNode& node : graph.nodes) {
    PutVertex(out, node.position_in_world, kWhite, SigmaOfNode(graph, node));
  }
  const std::vector<LinkId> curves = CurvesOf(graph);
  for (size_t id = 0; id < graph.links.size(); ++id) {
    const DrawingLink& link = graph.links[id];
    const Color color = ColorOfCurve(curves[id]);
    for (size_t i = 1; i + 1 < link.points_in_world.size(); ++i) {
      PutVertex(out, link.points_in_world[i], color, link.sigma[i]);
    }
  }
}

// Whether the edges say the class of their link.
bool HasClasses(const DrawingGraph& graph) {
  return std::any_of(graph.links.begin(), graph.links.end(),
                     [](const DrawingLink& link) { return link.dense.has_value(); });
}

void PutEdges(const DrawingGraph& graph, std::ostream& out) {
  const bool has_classes = HasClasses(graph);
  const bool has_kinds = HasKinds(graph);
  const bool has_rods = HasRods(graph);
  int32_t first_inner = static_cast<int32_t>(graph.nodes.size());
  const std::vector<LinkId> curves = CurvesOf(graph);
  for (size_t id = 0; id < graph.links.size(); ++id) {
    const DrawingLink& link = graph.links[id];
    const Color color = ColorOfCurve(curves[id]);
    const int32_t num_inner = static_cast<int32_t>(NumInnerPoints(link));
    int32_t previous = link.node0;
    for (int32_t i = 0; i <= num_inner; ++i) {
      const int32_t next = i < num_inner ? first_inner + i : link.node1;
      PutLittleEndian(out, previous);
      PutLittleEndian(out, next);
      PutColor(out, color);
      PutLittleEndian(out, static_cast<int32_t>(NumberOfLink(graph, id)));
      if (has_classes) {
        PutLittleEndian(out, static_cast<uint8_t>(ClassOf(link)));
      }
      if (has_kinds) PutLittleEndian(out, static_cast<uint8_t>(link.kind));
      if (has_rods) PutLittleEndian(out, link.rod_radius);
      previous = next;
    }
    first_inner += num_inner;
  }
}

}  // namespace

void WriteDrawingPly(const DrawingGraph& graph, LengthUnit unit, std::ostream& out) {
  size_t num_vertices = graph.nodes.size();
  size_t num_edges = 0;
  for (const DrawingLink& link : graph.links) {
    num_vertices += NumInnerPoints(link);
    num_edges += NumInnerPoints(link) + 1;
  }
  out << "ply\nformat binary_little_endian 1.0\n"
         "comment 3D drawing by limn: edges of one link have its color and id\n"
      << UnitComment(unit) << "element vertex " << num_vertices << '\n'
      << "property double x\nproperty double y\nproperty double z\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty double sigma\n"
      << "element edge " << num_edges << '\n'
      << "property int vertex1\nproperty int vertex2\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int link\n"
      << (HasClasses(graph) ? "comment class: 0 unknown, 1 surface, 2 boundary, 3 free\n"
                              "property uchar class\n"
                            : "")
      << (HasKinds(graph) ? "comment kind: 0 unknown, 1 edge, 2 paint, 3 shadow, 4 contour, 5 rod, "
                            "6 texture\nproperty uchar kind\n"
                          : "")
      << (HasRods(graph) ? "comment rod_radius: half the thickness of a rod, else 0\n"
                           "property double rod_radius\n"
                         : "")
      << "end_header\n";
  PutVertices(graph, out);
  PutEdges(graph, out);
}

}  // namespace limn
