// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/step/edges.h"

#include <algorithm>
#include <string>
#include <utility>

#include <GeomToStep_MakeCurve.hxx>
#include <Standard_Failure.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_Curve.hxx>
#include <TCollection_HAsciiString.hxx>

#include "limn/formats/step/curves.h"
#include "limn/formats/step/occt_versions.h"
#include "limn/util/errors.h"
#include "limn/util/number_text.h"

namespace limn {
namespace {

using opencascade::handle;

handle<StepShape_VertexPoint> MakeVertex(const Eigen::Vector3d& position) {
  const handle<TCollection_HAsciiString> no_name = new TCollection_HAsciiString("");
  handle<StepGeom_CartesianPoint> point = new StepGeom_CartesianPoint;
  point->Init3D(no_name, position.x(), position.y(), position.z());
  handle<StepShape_VertexPoint> vertex = new StepShape_VertexPoint;
  vertex->Init(no_name, point);
  return vertex;
}

handle<StepShape_EdgeCurve> MakeEdge(const DrawingLink& link, const std::string& name,
                                     handle<StepShape_VertexPoint> start,
                                     handle<StepShape_VertexPoint> end, bool reversed) {
  handle<StepShape_EdgeCurve> edge = new StepShape_EdgeCurve;
  if (reversed) std::swap(start, end);
  edge->Init(new TCollection_HAsciiString(name.c_str()), start, end,
             MadeBy<GeomToStep_MakeCurve>(GeomCurveOf(link)).Value(), /*same_sense=*/!reversed);
  return edge;
}

}  // namespace

std::string StepNameOf(const DrawingLink& link, LinkId id) {
  std::string name = "link_" + std::to_string(id);
  if (link.kind != LinkKind::kUnknown) name += std::string("_") + LinkKindName(link.kind);
  if (link.kind == LinkKind::kRod) name += '_' + NumberText(link.rod_radius);
  return name;
}

StepEdges MakeStepEdges(const DrawingGraph& graph, const std::vector<DrawingPath>& paths) {
  std::vector<handle<StepShape_VertexPoint>> vertices;
  std::vector<Eigen::Vector3d> positions;
  for (const DrawingNode& node : graph.nodes) {
    positions.push_back(PositionOfVertex(graph, node));
    vertices.push_back(MakeVertex(positions.back()));
  }
  StepEdges edges;
  edges.of_link.resize(graph.links.size());
  for (const DrawingPath& path : paths) {
    for (const PathStep& step : path) {
      const DrawingLink& link = graph.links[step.link];
      const std::string name = StepNameOf(link, NumberOfLink(graph, step.link));
      try {
        edges.of_link[step.link] =
            MakeEdge(link, name, vertices[link.node0], vertices[link.node1], step.reversed);
      } catch (const Standard_Failure& failure) {
        throw InputError(name + ": no curve of OpenCASCADE: " + failure.GetMessageString());
      }
      edges.gap = std::max({edges.gap, (EndOfCurve(link, 0) - positions[link.node0]).norm(),
                            (EndOfCurve(link, 1) - positions[link.node1]).norm()});
    }
  }
  return edges;
}

}  // namespace limn
