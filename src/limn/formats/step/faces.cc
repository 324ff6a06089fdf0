// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/step/faces.h"

#include <algorithm>
#include <cmath>

#include <BRepAdaptor_Curve.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <ShapeFix_Edge.hxx>
#include <ShapeFix_ShapeTolerance.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pln.hxx>

#include "limn/formats/step/curves.h"
#include "limn/formats/step/surfaces.h"
#include "limn/geometry/polygon_triangulation.h"

namespace limn {
namespace {

using opencascade::handle;
using Wire = std::vector<TopoDS_Edge>;

constexpr int kSamplesPerEdge = 24;

Wire WireOf(const std::vector<BorderStep>& steps, const std::vector<TopoDS_Edge>& edges) {
  Wire wire;
  for (const BorderStep& step : steps) {
    wire.push_back(edges[step.edge]);
    wire.back().Orientation(step.reversed ? TopAbs_REVERSED : TopAbs_FORWARD);
  }
  return wire;
}

Wire ReversedWire(Wire wire) {
  std::reverse(wire.begin(), wire.end());
  for (TopoDS_Edge& edge : wire) edge.Reverse();
  return wire;
}

// In its direction.
std::vector<Eigen::Vector3d> SamplesOf(const TopoDS_Edge& edge) {
  const BRepAdaptor_Curve curve(edge);
  std::vector<Eigen::Vector3d> samples;
  for (int k = 0; k <= kSamplesPerEdge; ++k) {
    double share = static_cast<double>(k) / kSamplesPerEdge;
    if (edge.Orientation() == TopAbs_REVERSED) share = 1 - share;
    const double range = curve.LastParameter() - curve.FirstParameter();
    samples.push_back(FromPnt(curve.Value(curve.FirstParameter() + share * range)));
  }
  return samples;
}

// Without the last point, which is the first of the next edge.
std::vector<Eigen::Vector3d> SamplesOf(const Wire& wire) {
  std::vector<Eigen::Vector3d> samples;
  for (const TopoDS_Edge& edge : wire) {
    const std::vector<Eigen::Vector3d> of_edge = SamplesOf(edge);
    samples.insert(samples.end(), of_edge.begin(), of_edge.end() - 1);
  }
  return samples;
}

TopoDS_Wire AsWire(const Wire& edges) {
  BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const TopoDS_Edge& edge : edges) builder.Add(wire, edge);
  wire.Closed(true);
  return wire;
}

TopoDS_Face AsFace(const handle<Geom_Surface>& surface, const std::vector<Wire>& wires) {
  BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, surface, Precision::Confusion());
  for (const Wire& wire : wires) builder.Add(face, AsWire(wire));
  return face;
}

class FaceMaker {
 public:
  FaceMaker(const DrawingFace& face, const BorderSheet& sheet,
            const std::vector<TopoDS_Edge>& edges, double max_gap_rel)
      : face_(face) {
    Eigen::AlignedBox3d box;
    for (const auto& side : sheet.sides) {
      sides_.push_back(WireOf(side, edges));
      for (const Eigen::Vector3d& point : SamplesOf(sides_.back())) box.extend(point);
    }
    max_gap_ = max_gap_rel * box.diagonal().norm();
  }

  std::optional<TopoDS_Face> Make() {
    // OpenCASCADE compares every edge with all others.
    constexpr size_t kMaxEdges = 500;
    size_t num_edges = 0;
    for (const Wire& side : sides_) num_edges += side.size();
    if (num_edges > kMaxEdges) return std::nullopt;
    if (face_.surface == FaceSurface::kPlane) return Checked(MakePlane());
    const double tolerance = 0.004 * max_gap_;
    const StepSurfaces surfaces = face_.surface == FaceSurface::kRuled
                                      ? RuledSurfaces(sides_, tolerance)
                                      : PatchSurfaces(sides_, tolerance);
    for (const auto& make_surface : surfaces) {
      const auto made = Try(make_surface);
      if (made) return made;
    }
    return std::nullopt;
  }

 private:
  std::optional<TopoDS_Face> MakePlane() {
    const Eigen::Vector3d on_plane =
        SamplesOf(sides_[0]).front() +
        (face_.offset - face_.normal.dot(SamplesOf(sides_[0]).front())) * face_.normal;
    const gp_Pln plane(ToPnt(on_plane), ToDir(face_.normal));
    std::vector<Wire> wires;
    for (const Wire& side : sides_) {
      const std::vector<Eigen::Vector3d> samples = SamplesOf(side);
      const bool is_outer = wires.empty();
      const bool is_counterclockwise = PolygonAreaVector(samples).dot(face_.normal) > 0;
      wires.push_back(is_counterclockwise == is_outer ? side : ReversedWire(side));
      for (const TopoDS_Edge& edge : side) {
        if (!WidenTo(plane, edge)) return std::nullopt;
      }
    }
    return AsFace(new Geom_Plane(plane), wires);
  }

  // Whether the edge is near enough to the plane; then its tolerance says how near.
  bool WidenTo(const gp_Pln& plane, const TopoDS_Edge& edge) const {
    double distance = 0;
    for (const Eigen::Vector3d& point : SamplesOf(edge)) {
      distance = std::max(distance, plane.Distance(ToPnt(point)));
    }
    constexpr double kMargin = 1.1;
    const double tolerance = kMargin * distance + Precision::Confusion();
    if (tolerance > max_gap_) return false;
    BRep_Builder().UpdateEdge(edge, tolerance);
    return true;
  }

  static std::optional<TopoDS_Face> Checked(std::optional<TopoDS_Face> made) {
    if (!made) return std::nullopt;
    BRepLib::UpdateTolerances(*made);
    return BRepCheck_Analyzer(*made).IsValid() ? made : std::nullopt;
  }

  // If there is no valid face, the edges are left as they were.
  std::optional<TopoDS_Face> Try(const std::function<handle<Geom_Surface>()>& make_surface) const {
    handle<Geom_Surface> surface;
    const std::vector<double> tolerances = Tolerances();
    try {
      surface = make_surface();
      if (surface.IsNull()) return std::nullopt;
      const auto made = Checked(MakeCurved(surface));
      if (made) return made;
    } catch (const Standard_Failure&) {
      if (surface.IsNull()) return std::nullopt;
    }
    size_t at = 0;
    for (const TopoDS_Shape& shape : EdgesAndVertices()) {
      ShapeFix_ShapeTolerance().SetTolerance(shape, tolerances[at++], shape.ShapeType());
      if (shape.ShapeType() != TopAbs_EDGE) continue;
      ShapeFix_Edge().FixRemovePCurve(TopoDS::Edge(shape), surface, TopLoc_Location());
    }
    return std::nullopt;
  }

  std::vector<TopoDS_Shape> EdgesAndVertices() const {
    std::vector<TopoDS_Shape> shapes;
    for (const Wire& side : sides_) {
      for (const TopoDS_Edge& edge : side) {
        shapes.push_back(edge);
        shapes.push_back(TopExp::FirstVertex(edge));
        shapes.push_back(TopExp::LastVertex(edge));
      }
    }
    return shapes;
  }

  std::vector<double> Tolerances() const {
    std::vector<double> tolerances;
    for (const TopoDS_Shape& shape : EdgesAndVertices()) {
      tolerances.push_back(shape.ShapeType() == TopAbs_EDGE
                               ? BRep_Tool::Tolerance(TopoDS::Edge(shape))
                               : BRep_Tool::Tolerance(TopoDS::Vertex(shape)));
    }
    return tolerances;
  }

  std::optional<TopoDS_Face> MakeCurved(const handle<Geom_Surface>& surface) const {
    Wire wire;
    for (const Wire& side : sides_) wire.insert(wire.end(), side.begin(), side.end());
    for (const TopoDS_Edge& edge : wire) {
      if (!AddCurveOn(surface, edge)) return std::nullopt;
    }
    // The border runs counterclockwise around the side that is seen.
    const TopoDS_Face face = AsFace(surface, {wire});
    const BRepTopAdaptor_FClass2d classifier(face, Precision::PConfusion());
    if (classifier.PerformInfinitePoint() == TopAbs_OUT) return face;
    TopoDS_Face reversed = AsFace(surface, {ReversedWire(wire)});
    reversed.Reverse();
    return reversed;
  }

  bool AddCurveOn(const handle<Geom_Surface>& surface, const TopoDS_Edge& edge) const {
    TopoDS_Edge forward = edge;
    forward.Orientation(TopAbs_FORWARD);
    ShapeFix_Edge fix;
    fix.FixAddPCurve(forward, surface, TopLoc_Location(), /*isSeam=*/false, Precision::Confusion());
    fix.FixSameParameter(forward);
    return BRep_Tool::Tolerance(forward) <= max_gap_;
  }

  const DrawingFace& face_;
  std::vector<Wire> sides_;
  double max_gap_ = 0;
};

}  // namespace

std::optional<TopoDS_Face> MakeStepFace(const DrawingGraph& graph, const BorderSheet& sheet,
                                        const std::vector<TopoDS_Edge>& edges, double max_gap_rel) {
  try {
    return FaceMaker(graph.faces[sheet.face], sheet, edges, max_gap_rel).Make();
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

}  // namespace limn
