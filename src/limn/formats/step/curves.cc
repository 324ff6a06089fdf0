// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/step/curves.h"

#include <variant>

#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <gp_Ax2.hxx>

namespace limn {
namespace {

using opencascade::handle;

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

}  // namespace

handle<Geom_Curve> GeomCurveOf(const CurveShape& shape) {
  return std::visit([](const auto& of) { return CurveOf(of); }, shape);
}

handle<Geom_Curve> GeomCurveOf(const std::vector<Eigen::Vector3d>& points) {
  std::vector<double> knots = {0};
  for (size_t i = 0; i < points.size(); ++i) knots.push_back(static_cast<double>(i));
  knots.push_back(knots.back());
  return BSpline(points, knots, 1);
}

handle<Geom_Curve> GeomCurveOf(const DrawingLink& link) {
  return link.primitive ? GeomCurveOf(link.primitive->shape) : GeomCurveOf(link.points_in_world);
}

Eigen::Vector3d EndOfCurve(const DrawingLink& link, int end) {
  if (link.primitive) return PointAt(link.primitive->shape, end);
  return end == 0 ? link.points_in_world.front() : link.points_in_world.back();
}

Eigen::Vector3d PositionOfVertex(const DrawingGraph& graph, const DrawingNode& node) {
  if (node.kind != NodeKind::kLoopAnchor && node.Degree() > 1) return node.position_in_world;
  const LinkEnd& first = node.incident.front();
  return EndOfCurve(graph.links[first.link], first.end);
}

}  // namespace limn
