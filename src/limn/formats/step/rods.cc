// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/step/rods.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>

#include "limn/formats/step/curves.h"

namespace limn {
namespace {

using opencascade::handle;

// A curve of OpenCASCADE between two parameters.
struct RodSpine {
  handle<Geom_Curve> curve;
  double first = 0;
  double last = 0;
};

RodSpine SpineOf(const CurveShape& shape) {
  const handle<Geom_Curve> curve = GeomCurveOf(shape);
  if (const auto* line = std::get_if<LineSegment>(&shape)) {
    return {curve, 0, (line->end - line->start).norm()};
  }
  if (const auto* arc = std::get_if<CircularArc>(&shape)) return {curve, 0, arc->sweep_rad};
  return {curve, curve->FirstParameter(), curve->LastParameter()};
}

// Whether the disk would sweep back over itself.
bool IsBentTooMuch(const RodSpine& spine, double radius) {
  constexpr int kCurvatureSamples = 256;
  for (int i = 0; i <= kCurvatureSamples; ++i) {
    gp_Pnt place;
    gp_Vec first, second;
    const double share = static_cast<double>(i) / kCurvatureSamples;
    spine.curve->D2(spine.first + share * (spine.last - spine.first), place, first, second);
    const double curvature = first.Crossed(second).Magnitude() / std::pow(first.Magnitude(), 3);
    if (!(curvature * radius < 1)) return true;
  }
  return false;
}

TopoDS_Face DiskAtStart(const RodSpine& spine, double radius) {
  gp_Pnt place;
  gp_Vec along;
  spine.curve->D1(spine.first, place, along);
  const TopoDS_Edge rim = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(place, gp_Dir(along)), radius));
  return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(rim).Wire());
}

std::optional<TopoDS_Solid> SolidOf(const TopoDS_Shape& swept) {
  if (swept.ShapeType() != TopAbs_SOLID) return std::nullopt;
  TopoDS_Solid solid = TopoDS::Solid(swept);
  if (!BRepLib::OrientClosedSolid(solid) || !BRepCheck_Analyzer(solid).IsValid()) {
    return std::nullopt;
  }
  return solid;
}

// Throws Standard_Failure.
std::optional<TopoDS_Solid> SweptAlong(const DrawingLink& rod) {
  const RodSpine spine = SpineOf(rod.primitive->shape);
  if (IsBentTooMuch(spine, rod.rod_radius)) return std::nullopt;
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(spine.curve, spine.first, spine.last);
  const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(edge);
  const TopoDS_Face disk = DiskAtStart(spine, rod.rod_radius);
  // Of the frames along a curve, the first turn least; only the others return on a closed one.
  for (const auto frames : {GeomFill_IsCorrectedFrenet, GeomFill_IsFrenet}) {
    BRepOffsetAPI_MakePipe pipe(wire, disk, frames);
    if (auto solid = SolidOf(pipe.Shape())) return solid;
  }
  return std::nullopt;
}

std::optional<TopoDS_Solid> TubeOf(const DrawingLink& rod) {
  if (!rod.primitive) return std::nullopt;
  try {
    return SweptAlong(rod);
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

double ToleranceOf(const TopoDS_Shape& shape) {
  return std::max(BRep_Tool::MaxTolerance(shape, TopAbs_EDGE),
                  BRep_Tool::MaxTolerance(shape, TopAbs_VERTEX));
}

}  // namespace

StepRods MakeStepRods(const DrawingGraph& graph) {
  StepRods rods;
  for (LinkId id = 0; id < static_cast<LinkId>(graph.links.size()); ++id) {
    if (graph.links[id].kind != LinkKind::kRod) continue;
    const std::optional<TopoDS_Solid> tube = TubeOf(graph.links[id]);
    if (!tube) {
      rods.left_out.push_back(id);
      continue;
    }
    rods.tolerance = std::max(rods.tolerance, ToleranceOf(*tube));
    rods.tubes.push_back({*tube, id});
  }
  return rods;
}

}  // namespace limn
