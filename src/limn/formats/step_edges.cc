#include "limn/formats/step_edges.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include <GeomToStep_MakeCartesianPoint.hxx>
#include <GeomToStep_MakeCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <Standard_Failure.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_Curve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TCollection_HAsciiString.hxx>
#include <gp_Ax2.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>

#include "limn/util/errors.h"

namespace limn {
namespace {

using opencascade::handle;

gp_Pnt ToPnt(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }
gp_Dir ToDir(const Eigen::Vector3d& axis) { return {axis.x(), axis.y(), axis.z()}; }

// Each knot once, with the number of times it stands in `knots`.
handle<Geom_Curve> BSpline(const std::vector<Eigen::Vector3d>& points,
                           const std::vector<double>& knots, int degree) {
  std::vector<double> values;
  std::vector<int> times;
  for (const double knot : knots) {
    if (values.empty() || knot != values.back()) {
      values.push_back(knot);
      times.push_back(0);
    }
    ++times.back();
  }
  TColgp_Array1OfPnt poles(1, static_cast<int>(points.size()));
  for (size_t i = 0; i < points.size(); ++i) poles(static_cast<int>(i) + 1) = ToPnt(points[i]);
  TColStd_Array1OfReal distinct(1, static_cast<int>(values.size()));
  TColStd_Array1OfInteger multiplicities(1, static_cast<int>(values.size()));
  for (size_t i = 0; i < values.size(); ++i) {
    distinct(static_cast<int>(i) + 1) = values[i];
    multiplicities(static_cast<int>(i) + 1) = times[i];
  }
  return new Geom_BSplineCurve(poles, distinct, multiplicities, degree);
}

handle<Geom_Curve> CurveOf(const LineSegment& line) {
  return new Geom_Line(ToPnt(line.start), ToDir((line.end - line.start).normalized()));
}

handle<Geom_Curve> CurveOf(const CircularArc& arc) {
  return new Geom_Circle(gp_Ax2(ToPnt(arc.center), ToDir(arc.Normal()), ToDir(arc.x_axis)),
                         arc.radius);
}

handle<Geom_Curve> CurveOf(const CubicBSpline& spline) {
  return BSpline(spline.control_points, spline.knots, 3);
}

// Every segment of the polyline has a knot interval of the same length.
handle<Geom_Curve> CurveOf(const std::vector<Eigen::Vector3d>& points) {
  std::vector<double> knots = {0};
  for (size_t i = 0; i < points.size(); ++i) knots.push_back(static_cast<double>(i));
  knots.push_back(knots.back());
  return BSpline(points, knots, 1);
}

handle<Geom_Curve> CurveOf(const DrawingLink& link) {
  if (!link.primitive) return CurveOf(link.points_in_world);
  return std::visit([](const auto& shape) { return CurveOf(shape); }, link.primitive->shape);
}

Eigen::Vector3d EndOfCurve(const DrawingLink& link, int end) {
  if (link.primitive) return PointAt(link.primitive->shape, end);
  return end == 0 ? link.points_in_world.front() : link.points_in_world.back();
}

handle<StepShape_VertexPoint> MakeVertex(const Eigen::Vector3d& position) {
  handle<StepShape_VertexPoint> vertex = new StepShape_VertexPoint;
  vertex->Init(new TCollection_HAsciiString(""),
               GeomToStep_MakeCartesianPoint(ToPnt(position)).Value());
  return vertex;
}

// Where the links of a node meet. Ends without company, and where a closed link begins, are ends of
// curves: a primitive need not go through these nodes.
Eigen::Vector3d PositionOfVertex(const DrawingGraph& graph, const DrawingNode& node) {
  if (node.kind != NodeKind::kLoopAnchor && node.Degree() > 1) return node.position_in_world;
  const LinkEnd& first = node.incident.front();
  return EndOfCurve(graph.links[first.link], first.end);
}

handle<StepShape_EdgeCurve> MakeEdge(const DrawingLink& link, const std::string& name,
                                     handle<StepShape_VertexPoint> start,
                                     handle<StepShape_VertexPoint> end, bool reversed) {
  handle<StepShape_EdgeCurve> edge = new StepShape_EdgeCurve;
  if (reversed) std::swap(start, end);
  edge->Init(new TCollection_HAsciiString(name.c_str()), start, end,
             GeomToStep_MakeCurve(CurveOf(link)).Value(), /*same_sense=*/!reversed);
  return edge;
}

}  // namespace

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
      std::string name = "link_" + std::to_string(step.link);
      if (link.kind != LinkKind::kUnknown) name += std::string("_") + LinkKindName(link.kind);
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
