// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/step/surfaces.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert_CompCurveToBSplineCurve.hxx>
#include <GeomFill.hxx>
#include <GeomFill_BSplineCurves.hxx>
#include <GeomPlate_BuildPlateSurface.hxx>
#include <GeomPlate_CurveConstraint.hxx>
#include <GeomPlate_MakeApprox.hxx>
#include <GeomPlate_Surface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>

namespace limn {
namespace {

using opencascade::handle;
using Side = std::vector<TopoDS_Edge>;

gp_Pnt PointOfEdge(const TopoDS_Edge& edge, double share) {
  double first = 0, last = 0;
  const handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
  if (edge.Orientation() == TopAbs_REVERSED) share = 1 - share;
  return curve->Value(first + share * (last - first));
}

// The curves of a side as one, in its direction.
handle<Geom_BSplineCurve> CurveOfSide(const Side& side, double tolerance,
                                      Convert_ParameterisationType circles) {
  GeomConvert_CompCurveToBSplineCurve joined(circles);
  for (const TopoDS_Edge& edge : side) {
    double first = 0, last = 0;
    const handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
    handle<Geom_TrimmedCurve> part = new Geom_TrimmedCurve(curve, first, last);
    if (edge.Orientation() == TopAbs_REVERSED) part->Reverse();
    if (!joined.Add(part, tolerance, /*After=*/true)) return nullptr;
  }
  return joined.BSplineCurve();
}

// The circle that a side is on.
std::optional<gp_Circ> CircleOfSide(const Side& side, double tolerance) {
  std::optional<gp_Circ> circle;
  for (const TopoDS_Edge& edge : side) {
    const BRepAdaptor_Curve curve(edge);
    if (curve.GetType() != GeomAbs_Circle) return std::nullopt;
    const gp_Circ of_edge = curve.Circle();
    if (!circle) circle = of_edge;
    if (of_edge.Location().Distance(circle->Location()) > tolerance ||
        std::abs(of_edge.Radius() - circle->Radius()) > tolerance) {
      return std::nullopt;
    }
  }
  return circle;
}

gp_Pnt MiddleOfSide(const Side& side) {
  if (side.size() % 2 == 0) return PointOfEdge(side[side.size() / 2], 0);
  return PointOfEdge(side[side.size() / 2], 0.5);
}

// The cone widens along its axis: STEP has no negative angles. Its u runs around the axis from the
// side opposite to `middle`.
handle<Geom_Surface> SurfaceOfRevolution(const gp_Circ& from, const gp_Circ& to,
                                         const gp_Pnt& middle, double tolerance) {
  const gp_Vec axis(from.Location(), to.Location());
  const double height = axis.Magnitude();
  if (height <= tolerance) return nullptr;
  const double sine = tolerance / std::max(from.Radius(), to.Radius());
  if (std::abs(gp_Vec(from.Axis().Direction()).Crossed(axis).Magnitude()) > sine * height ||
      std::abs(gp_Vec(to.Axis().Direction()).Crossed(axis).Magnitude()) > sine * height) {
    return nullptr;
  }
  const gp_Dir opposite(gp_Vec(middle, from.Location()));
  const double widening = to.Radius() - from.Radius();
  if (std::abs(widening) <= tolerance) {
    return new Geom_CylindricalSurface(gp_Ax3(from.Location(), gp_Dir(axis), opposite),
                                       (from.Radius() + to.Radius()) / 2);
  }
  const gp_Circ& narrow = widening > 0 ? from : to;
  const gp_Dir widens(widening > 0 ? axis : axis.Reversed());
  return new Geom_ConicalSurface(gp_Ax3(narrow.Location(), widens, opposite),
                                 std::atan2(std::abs(widening), height), narrow.Radius());
}

handle<Geom_Surface> PlateSurface(const std::vector<Side>& sides, double tolerance) {
  constexpr int kDegree = 3, kPointsPerCurve = 15, kIterations = 2, kMaxSegments = 9;
  constexpr int kMaxDegree = 8, kContinuous = 0;
  GeomPlate_BuildPlateSurface plate(kDegree, kPointsPerCurve, kIterations);
  for (const Side& side : sides) {
    for (const TopoDS_Edge& edge : side) {
      const handle<Adaptor3d_Curve> curve = new BRepAdaptor_Curve(edge);
      plate.Add(new GeomPlate_CurveConstraint(curve, kContinuous, kPointsPerCurve, tolerance));
    }
  }
  plate.Perform();
  if (!plate.IsDone()) return nullptr;
  const GeomPlate_MakeApprox approximation(plate.Surface(), tolerance, kMaxSegments, kMaxDegree,
                                           std::max(tolerance, 10 * plate.G0Error()), kContinuous);
  return approximation.Surface();
}

handle<Geom_Surface> RoundSurface(const std::vector<Side>& sides, double tolerance) {
  const auto from = CircleOfSide(sides[0], tolerance), to = CircleOfSide(sides[2], tolerance);
  if (!from || !to) return nullptr;
  return SurfaceOfRevolution(*from, *to, MiddleOfSide(sides[0]), tolerance);
}

handle<Geom_Surface> LinesBetweenRails(const std::vector<Side>& sides, double tolerance) {
  const auto rail = CurveOfSide(sides[0], tolerance, Convert_TgtThetaOver2);
  const auto other = CurveOfSide(sides[2], tolerance, Convert_TgtThetaOver2);
  if (rail.IsNull() || other.IsNull()) return nullptr;
  other->Reverse();
  return GeomFill::Surface(rail, other);
}

handle<Geom_Surface> CoonsSurface(const std::vector<Side>& sides, double tolerance) {
  if (sides.size() != 4) return nullptr;
  handle<Geom_BSplineCurve> curves[4];
  for (int s = 0; s < 4; ++s) {
    // Coons' surface of rational curves is not implemented.
    curves[s] = CurveOfSide(sides[s], tolerance, Convert_Polynomial);
    if (curves[s].IsNull()) return nullptr;
  }
  const GeomFill_BSplineCurves coons(curves[0], curves[1], curves[2], curves[3],
                                     GeomFill_CoonsStyle);
  return handle<Geom_Surface>(coons.Surface());
}

}  // namespace

StepSurfaces RuledSurfaces(const std::vector<std::vector<TopoDS_Edge>>& sides, double tolerance) {
  return {[&sides, tolerance] { return RoundSurface(sides, tolerance); },
          [&sides, tolerance] { return LinesBetweenRails(sides, tolerance); }};
}

StepSurfaces PatchSurfaces(const std::vector<std::vector<TopoDS_Edge>>& sides, double tolerance) {
  return {[&sides, tolerance] { return CoonsSurface(sides, tolerance); },
          [&sides, tolerance] { return PlateSurface(sides, tolerance); }};
}

}  // namespace limn
