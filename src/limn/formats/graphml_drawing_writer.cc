// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/graphml_drawing_writer.h"

#include <ostream>

#include "limn/formats/link_kind.h"
#include "limn/geometry/polyline.h"
#include "limn/util/number_text.h"

namespace limn {
namespace {

struct Attribute {
  const char* of;
  const char* name;
  const char* type;
};

constexpr Attribute kAttributes[] = {
    {"graph", "unit", "string"},
    {"node", "x", "double"},
    {"node", "y", "double"},
    {"node", "z", "double"},
    {"node", "kind", "string"},
    {"node", "degree", "int"},
    {"edge", "link", "int"},
    {"edge", "length", "double"},
    {"edge", "points", "int"},
    {"edge", "views", "int"},
    {"edge", "residual_px", "double"},
    {"edge", "primitive", "string"},
    {"edge", "class", "string"},
    {"edge", "edge_kind", "string"},
    {"edge", "kind_confidence", "double"},
    {"edge", "tentative", "boolean"},
    {"edge", "rod_radius", "double"},
};

void PutHead(std::ostream& out) {
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\"\n"
         "         xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\"\n"
         "         xsi:schemaLocation=\"http://graphml.graphdrawing.org/xmlns "
         "http://graphml.graphdrawing.org/xmlns/1.0/graphml.xsd\">\n";
  for (const Attribute& attribute : kAttributes) {
    out << "<key id=\"" << attribute.name << "\" for=\"" << attribute.of << "\" attr.name=\""
        << attribute.name << "\" attr.type=\"" << attribute.type << "\"/>\n";
  }
}

// Values are numbers and words of our own: nothing to escape.
void Put(const char* key, const std::string& value, std::ostream& out) {
  out << "<data key=\"" << key << "\">" << value << "</data>";
}

void PutNode(const DrawingGraph& graph, size_t id, std::ostream& out) {
  const DrawingNode& node = graph.nodes[id];
  out << "<node id=\"n" << NumberOfNode(graph, id) << "\">";
  Put("x", NumberText(node.position_in_world.x()), out);
  Put("y", NumberText(node.position_in_world.y()), out);
  Put("z", NumberText(node.position_in_world.z()), out);
  Put("kind", NodeKindName(node.kind), out);
  Put("degree", std::to_string(node.Degree()), out);
  out << "</node>\n";
}

void PutLink(const DrawingGraph& graph, size_t id, std::ostream& out) {
  const DrawingLink& link = graph.links[id];
  const LinkId number = NumberOfLink(graph, id);
  out << "<edge id=\"l" << number << "\" source=\"n" << NumberOfNode(graph, link.node0)
      << "\" target=\"n" << NumberOfNode(graph, link.node1) << "\">";
  Put("link", std::to_string(number), out);
  Put("length", NumberText(Length(link.points_in_world)), out);
  Put("points", std::to_string(link.points_in_world.size()), out);
  Put("views", std::to_string(link.supporting_views.size()), out);
  Put("residual_px", NumberText(link.residual_px), out);
  Put("primitive", PrimitiveName(link), out);
  Put("class", DenseClassName(ClassOf(link)), out);
  Put("edge_kind", LinkKindName(link.kind), out);
  Put("kind_confidence", NumberText(link.kind_confidence), out);
  Put("tentative", link.tentative ? "true" : "false", out);
  Put("rod_radius", NumberText(link.rod_radius), out);
  out << "</edge>\n";
}

}  // namespace

void WriteDrawingGraphml(const DrawingGraph& graph, LengthUnit unit, std::ostream& out) {
  PutHead(out);
  out << "<graph id=\"drawing\" edgedefault=\"undirected\">\n";
  if (unit != LengthUnit::kNone) {
    Put("unit", UnitName(unit), out);
    out << '\n';
  }
  for (size_t id = 0; id < graph.nodes.size(); ++id) PutNode(graph, id, out);
  for (size_t id = 0; id < graph.links.size(); ++id) PutLink(graph, id, out);
  out << "</graph>\n</graphml>\n";
}

}  // namespace limn
