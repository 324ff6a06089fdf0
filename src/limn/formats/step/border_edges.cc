// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/step/border_edges.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <BRep_Builder.hxx>
#include <Eigen/Geometry>
#include <GC_MakeArcOfCircle.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Ax2.hxx>

#include "limn/formats/step/curves.h"

namespace limn {
namespace {

using opencascade::handle;

struct TrimmedCurve {
  handle<Geom_Curve> curve;
  double first = 0;
  double last = 0;
};

// normal . x = offset.
struct BorderPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double offset = 0;
};

// As far from all planes of a border, which are nearly one.
BorderPlane MeanPlane(const std::vector<DrawingFace>& faces, const std::vector<int>& planes) {
  BorderPlane mean;
  for (const int face : planes) {
    const DrawingFace& plane = faces[face];
    const double sign = plane.normal.dot(faces[planes.front()].normal) < 0 ? -1 : 1;
    mean.normal += sign * plane.normal;
    mean.offset += sign * plane.offset;
  }
  mean.offset /= mean.normal.norm();
  mean.normal.normalize();
  return mean;
}

Eigen::Vector3d ProjectedOnto(const BorderPlane& plane, const Eigen::Vector3d& point) {
  return point + (plane.offset - plane.normal.dot(point)) * plane.normal;
}

TrimmedCurve LineBetween(const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
  const Eigen::Vector3d along = end - start;
  return {new Geom_Line(ToPnt(start), ToDir(along.normalized())), 0, along.norm()};
}

// In the plane; none if it is far from parallel to it.
std::optional<CircularArc> ProjectedArc(const BorderPlane& plane, const CircularArc& arc) {
  constexpr double kLeastCosine = 0.98;
  const double cosine = arc.Normal().dot(plane.normal);
  if (std::abs(cosine) < kLeastCosine) return std::nullopt;
  CircularArc projected = arc;
  const Eigen::Vector3d normal = cosine > 0 ? plane.normal : Eigen::Vector3d(-plane.normal);
  projected.center = ProjectedOnto(plane, arc.center);
  projected.x_axis = (arc.x_axis - normal.dot(arc.x_axis) * normal).normalized();
  projected.y_axis = normal.cross(projected.x_axis);
  return projected;
}

// Counterclockwise from one vertex to the other.
TrimmedCurve ArcBetween(CircularArc arc, const Eigen::Vector3d& start, const Eigen::Vector3d& end,
                        bool is_whole) {
  constexpr double kOnCircle = 1e-9;
  const double angle = AngleOn(arc, start);
  const Eigen::Vector3d x_axis = std::cos(angle) * arc.x_axis + std::sin(angle) * arc.y_axis;
  arc.y_axis = std::cos(angle) * arc.y_axis - std::sin(angle) * arc.x_axis;
  arc.x_axis = x_axis;
  double sweep = is_whole ? 2 * M_PI : AngleOn(arc, end);
  if (sweep <= 0) sweep += 2 * M_PI;
  const bool is_exact = std::max(DistanceFromCircle(arc, start), DistanceFromCircle(arc, end)) <
                        kOnCircle * (arc.radius + arc.center.norm());
  if (is_whole || is_exact) return {GeomCurveOf(CurveShape(arc)), 0, sweep};
  arc.sweep_rad = sweep;
  const GC_MakeArcOfCircle through(ToPnt(start), ToPnt(PointAt(arc, 0.5)), ToPnt(end));
  if (!through.IsDone()) return LineBetween(start, end);
  return {through.Value()->BasisCurve(), through.Value()->FirstParameter(),
          through.Value()->LastParameter()};
}

// Moves the poles so that the curve, which is clamped, goes from one vertex to the other.
void MoveEnds(const Eigen::Vector3d& start, const Eigen::Vector3d& end,
              const handle<Geom_BSplineCurve>& spline) {
  const int count = spline->NbPoles();
  const Eigen::Vector3d at_start = start - FromPnt(spline->StartPoint());
  const Eigen::Vector3d at_end = end - FromPnt(spline->EndPoint());
  for (int i = 1; i <= count; ++i) {
    const double share = (i - 1.0) / (count - 1);
    const Eigen::Vector3d move = (1 - share) * at_start + share * at_end;
    spline->SetPole(i, ToPnt(FromPnt(spline->Pole(i)) + move));
  }
}

double ParameterOn(const handle<Geom_BSplineCurve>& spline, const Eigen::Vector3d& point) {
  const GeomAPI_ProjectPointOnCurve projection(ToPnt(point), spline);
  const double to_start = (point - FromPnt(spline->StartPoint())).norm();
  const double to_end = (point - FromPnt(spline->EndPoint())).norm();
  const double to_inner =
      projection.NbPoints() > 0 ? projection.LowerDistance() : to_start + to_end;
  if (to_inner <= std::min(to_start, to_end)) return projection.LowerDistanceParameter();
  return to_start < to_end ? spline->FirstParameter() : spline->LastParameter();
}

class EdgeMaker {
 public:
  EdgeMaker(const DrawingGraph& graph, const FaceBorders& borders)
      : graph_(graph), borders_(borders) {
    for (const Eigen::Vector3d& position : borders.vertices) {
      builder_.MakeVertex(vertices_.emplace_back(), ToPnt(position), Precision::Confusion());
    }
  }

  TopoDS_Edge Make(const BorderEdge& border) {
    const TrimmedCurve trimmed = CurveOfBorder(border);
    TopoDS_Edge edge;
    builder_.MakeEdge(edge, trimmed.curve, Precision::Confusion());
    AddVertex(border.start, TopAbs_FORWARD, trimmed, trimmed.first, &edge);
    AddVertex(border.end, TopAbs_REVERSED, trimmed, trimmed.last, &edge);
    builder_.Range(edge, trimmed.first, trimmed.last);
    return edge;
  }

 private:
  void AddVertex(int vertex, TopAbs_Orientation orientation, const TrimmedCurve& trimmed,
                 double parameter, TopoDS_Edge* edge) {
    const double gap =
        (FromPnt(trimmed.curve->Value(parameter)) - borders_.vertices[vertex]).norm();
    builder_.UpdateVertex(vertices_[vertex], gap + Precision::Confusion());
    builder_.Add(*edge, vertices_[vertex].Oriented(orientation));
  }

  std::optional<BorderPlane> PlaneOf(const BorderEdge& border) const {
    if (border.planes.empty()) return std::nullopt;
    return MeanPlane(graph_.faces, border.planes);
  }

  // Two planes meet in a straight line.
  bool IsBetweenPlanes(const BorderEdge& border) const {
    constexpr double kMaxCosine = 0.98;
    if (border.start == border.end) return false;
    return std::ranges::any_of(border.planes, [&](int face) {
      const Eigen::Vector3d& first = graph_.faces[border.planes.front()].normal;
      return std::abs(graph_.faces[face].normal.dot(first)) < kMaxCosine;
    });
  }

  TrimmedCurve CurveOfBorder(const BorderEdge& border) const {
    const Eigen::Vector3d& start = borders_.vertices[border.start];
    const Eigen::Vector3d& end = borders_.vertices[border.end];
    if (IsBetweenPlanes(border)) return LineBetween(start, end);
    const CurveShape* shape = nullptr;
    if (!border.IsBridge() && graph_.links[border.link].primitive) {
      shape = &graph_.links[border.link].primitive->shape;
    }
    if (shape && std::holds_alternative<LineSegment>(*shape)) return LineBetween(start, end);
    if (border.of_points) return Polyline(border);
    if (shape && std::holds_alternative<CircularArc>(*shape)) {
      const std::optional<BorderPlane> plane = PlaneOf(border);
      const CircularArc& arc = std::get<CircularArc>(*shape);
      return ArcBetween(plane ? ProjectedArc(*plane, arc).value_or(arc) : arc, start, end,
                        border.start == border.end);
    }
    if (shape) return PartOfSpline(border, std::get<CubicBSpline>(*shape));
    return Polyline(border);
  }

  TrimmedCurve PartOfSpline(const BorderEdge& border, CubicBSpline shape) const {
    const auto whole = handle<Geom_BSplineCurve>::DownCast(GeomCurveOf(CurveShape(shape)));
    const double last = graph_.links[border.link].size() - 1;
    const double from =
        border.from == 0 ? whole->FirstParameter() : ParameterOn(whole, border.course.front());
    const double to =
        border.to == last ? whole->LastParameter() : ParameterOn(whole, border.course.back());
    if (!(to - from > Precision::PConfusion())) return Polyline(border);
    if (const auto plane = PlaneOf(border)) {
      for (Eigen::Vector3d& point : shape.control_points) point = ProjectedOnto(*plane, point);
    }
    const auto spline = handle<Geom_BSplineCurve>::DownCast(GeomCurveOf(CurveShape(shape)));
    spline->Segment(from, to);
    MoveEnds(borders_.vertices[border.start], borders_.vertices[border.end], spline);
    return {handle<Geom_Curve>(spline), spline->FirstParameter(), spline->LastParameter()};
  }

  TrimmedCurve Polyline(const BorderEdge& border) const {
    std::vector<Eigen::Vector3d> points = border.course;
    if (const auto plane = PlaneOf(border)) {
      for (Eigen::Vector3d& point : points) point = ProjectedOnto(*plane, point);
    }
    points.front() = borders_.vertices[border.start];
    points.back() = borders_.vertices[border.end];
    const auto near = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      return (a - b).norm() <= 2 * Precision::Confusion();
    };
    points.erase(std::unique(points.begin() + 1, points.end() - 1, near), points.end() - 1);
    if (points.size() == 2) return LineBetween(points.front(), points.back());
    const handle<Geom_Curve> curve = GeomCurveOf(points);
    return {curve, curve->FirstParameter(), curve->LastParameter()};
  }

  const DrawingGraph& graph_;
  const FaceBorders& borders_;
  BRep_Builder builder_;
  std::vector<TopoDS_Vertex> vertices_;
};

}  // namespace

std::vector<TopoDS_Edge> MakeBorderEdges(const DrawingGraph& graph, const FaceBorders& borders) {
  EdgeMaker maker(graph, borders);
  std::vector<TopoDS_Edge> edges;
  for (const BorderEdge& border : borders.edges) edges.push_back(maker.Make(border));
  return edges;
}

}  // namespace limn
