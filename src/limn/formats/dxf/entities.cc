// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/dxf/entities.h"

#include <cmath>
#include <span>
#include <variant>

#include <Eigen/Geometry>

#include "limn/formats/dxf/chains.h"
#include "limn/formats/dxf/object_axes.h"
#include "limn/formats/triangle_parts.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

double DegreesWithinATurn(double rad) {
  const double degrees = std::fmod(Degrees(rad), 360.0);
  return degrees < 0 ? degrees + 360 : degrees;
}

class EntityWriter {
 public:
  EntityWriter(const DxfLayerPlan& plan, int model_space, int* next_handle, DxfWriter* writer)
      : plan_(plan), model_space_(model_space), next_handle_(next_handle), writer_(*writer) {}

  void PutLink(const DrawingLink& link, int layer, LinkId number) {
    SetMarks(layer, number, link.rod_radius);
    if (link.primitive) {
      std::visit([this](const auto& shape) { Put(shape); }, link.primitive->shape);
    } else {
      const bool closed = link.node0 == link.node1;
      PutPolyline(std::span(link.points_in_world).first(link.size() - (closed ? 1 : 0)), closed);
    }
  }

  // Links of a plan. `layers`: one per link.
  void PutFlat(const FlatLinks& flat, const std::vector<int>& layers, double tolerance) {
    const DrawingGraph& graph = flat.graph;
    std::vector<uint8_t> in_chain(graph.links.size(), 0);
    for (const FlatChain& chain : FindChains(flat, layers, tolerance)) {
      for (const LinkId id : chain.links) in_chain[id] = 1;
      PutChain(chain, graph, layers[chain.links.front()]);
    }
    for (size_t id = 0; id < graph.links.size(); ++id) {
      if (in_chain[id]) continue;
      const DrawingLink& link = graph.links[id];
      if (flat.ellipses[id]) {
        SetMarks(layers[id], NumberOfLink(graph, id), link.rod_radius);
        Put(*flat.ellipses[id]);
      } else {
        PutLink(link, layers[id], NumberOfLink(graph, id));
      }
    }
  }

  // A part of a face.
  void PutFace(const TrianglePart& part, int face) {
    SetMarks(plan_.of_face[face], face);
    PutPolyface(part);
  }

  void PutPoint(const Eigen::Vector3d& position, int layer, int id) {
    SetMarks(layer, id);
    Begin("POINT", "AcDbPoint", model_space_);
    writer_.PutPoint(10, position);
    PutExtendedData();
  }

  void PutSection(const Section& section) {
    for (size_t i = 0; i < section.lines.size(); ++i) {
      SetMarks(plan_.of_section, static_cast<int>(i));
      std::vector<ChainVertex> vertices;
      for (const Eigen::Vector3d& point : section.lines[i].points) {
        vertices.push_back({point.head<2>()});
      }
      PutFlatPolyline(vertices, section.lines[i].closed);
    }
    for (size_t i = 0; i < section.points.size(); ++i) {
      PutPoint(section.points[i], plan_.of_section_points, static_cast<int>(i));
    }
  }

 private:
  // Of the entity that is put next.
  void SetMarks(int layer, int id, double rod_radius = 0) {
    layer_ = plan_.layers[layer].name;
    ids_ = {id};
    rod_radius_ = rod_radius;
  }

  void PutChain(const FlatChain& chain, const DrawingGraph& graph, int layer) {
    const DrawingLink& first = graph.links[chain.links.front()];
    if (chain.links.size() == 1 && first.primitive) {
      PutLink(first, layer, NumberOfLink(graph, chain.links.front()));
      return;
    }
    SetMarks(layer, 0);
    ids_.clear();
    for (const LinkId id : chain.links) {
      const LinkId number = NumberOfLink(graph, id);
      if (ids_.empty() || ids_.back() != number) ids_.push_back(number);
    }
    const auto place = [&](size_t i) -> Eigen::Vector3d {
      return {chain.vertices[i].place.x(), chain.vertices[i].place.y(), 0};
    };
    if (!chain.closed && chain.vertices.size() == 2 && chain.vertices[0].bulge == 0) {
      Put(LineSegment{place(0), place(1)});
    } else {
      PutFlatPolyline(chain.vertices, chain.closed);
    }
  }

  // Returns the handle.
  int Begin(const char* type, const char* subclass, int owner) {
    const int handle = (*next_handle_)++;
    writer_.Put(0, type);
    writer_.PutHandle(5, handle);
    writer_.PutHandle(330, owner);
    writer_.Put(100, "AcDbEntity");
    writer_.Put(8, layer_);
    if (subclass) writer_.Put(100, subclass);
    return handle;
  }

  void PutExtendedData() {
    writer_.Put(1001, kDxfApplication);
    for (const int id : ids_) writer_.Put(1071, id);
    if (rod_radius_ > 0) writer_.Put(1041, rod_radius_);  // scaled with the entity
  }

  void Put(const LineSegment& line) {
    Begin("LINE", "AcDbLine", model_space_);
    writer_.PutPoint(10, line.start);
    writer_.PutPoint(11, line.end);
    PutExtendedData();
  }

  void Put(const CircularArc& arc) {
    const Eigen::Vector3d normal = arc.Normal().normalized();
    const Eigen::Matrix3d object_from_world = ObjectFromWorld(normal);
    Begin(arc.IsCircle() ? "CIRCLE" : "ARC", "AcDbCircle", model_space_);
    writer_.PutPoint(10, object_from_world * arc.center);
    writer_.Put(40, arc.radius);
    writer_.PutPoint(210, normal);
    if (!arc.IsCircle()) {
      // Arcs run counter-clockwise about the normal, as ours do.
      const Eigen::Vector3d start = object_from_world * arc.x_axis;
      const double start_rad = std::atan2(start.y(), start.x());
      writer_.Put(100, "AcDbArc");
      writer_.Put(50, DegreesWithinATurn(start_rad));
      writer_.Put(51, DegreesWithinATurn(start_rad + arc.sweep_rad));
    }
    PutExtendedData();
  }

  void Put(const CubicBSpline& spline) {
    constexpr double kTolerance = 1e-10;
    Begin("SPLINE", "AcDbSpline", model_space_);
    writer_.Put(70, 0);  // not periodic, not rational, not known to be flat
    writer_.Put(71, 3);
    writer_.Put(72, static_cast<int>(spline.knots.size()));
    writer_.Put(73, static_cast<int>(spline.control_points.size()));
    writer_.Put(74, 0);
    writer_.Put(42, kTolerance);
    writer_.Put(43, kTolerance);
    for (const double knot : spline.knots) writer_.Put(40, knot);
    for (const Eigen::Vector3d& point : spline.control_points) writer_.PutPoint(10, point);
    PutExtendedData();
  }

  void Put(const EllipticalArc& arc) {
    Begin("ELLIPSE", "AcDbEllipse", model_space_);
    writer_.PutPoint(10, arc.center);
    writer_.PutPoint(11, arc.major);
    writer_.PutPoint(210, Eigen::Vector3d::UnitZ());
    writer_.Put(40, arc.Ratio());
    writer_.Put(41, arc.begin_rad);
    writer_.Put(42, arc.end_rad);
    PutExtendedData();
  }

  void PutFlatPolyline(const std::vector<ChainVertex>& vertices, bool closed) {
    constexpr int kDashesThroughVertices = 128;
    Begin("LWPOLYLINE", "AcDbPolyline", model_space_);
    writer_.Put(90, static_cast<int>(vertices.size()));
    writer_.Put(70, kDashesThroughVertices + (closed ? 1 : 0));
    for (const ChainVertex& vertex : vertices) {
      writer_.Put(10, vertex.place.x());
      writer_.Put(20, vertex.place.y());
      if (vertex.bulge != 0) writer_.Put(42, vertex.bulge);
    }
    PutExtendedData();
  }

  // A closed one returns to its first vertex by itself.
  void PutPolyline(std::span<const Eigen::Vector3d> points, bool closed) {
    const int polyline = Begin("POLYLINE", "AcDb3dPolyline", model_space_);
    writer_.Put(66, 1);
    writer_.PutPoint(10, Eigen::Vector3d::Zero());
    writer_.Put(70, closed ? 8 + 1 : 8);
    PutExtendedData();
    for (const Eigen::Vector3d& point : points) {
      Begin("VERTEX", "AcDbVertex", polyline);
      writer_.Put(100, "AcDb3dPolylineVertex");
      writer_.PutPoint(10, point);
      writer_.Put(70, 32);
    }
    Begin("SEQEND", nullptr, polyline);
  }

  void PutPolyface(const TrianglePart& part) {
    const int polyline = Begin("POLYLINE", "AcDbPolyFaceMesh", model_space_);
    writer_.Put(66, 1);
    writer_.PutPoint(10, Eigen::Vector3d::Zero());
    writer_.Put(70, 64);
    writer_.Put(71, static_cast<int>(part.vertices.size()));
    writer_.Put(72, static_cast<int>(part.triangles.size()));
    PutExtendedData();
    for (const Eigen::Vector3d& vertex : part.vertices) {
      Begin("VERTEX", "AcDbVertex", polyline);
      writer_.Put(100, "AcDbPolyFaceMeshVertex");
      writer_.PutPoint(10, vertex);
      writer_.Put(70, 64 + 128);
    }
    for (size_t t = 0; t < part.triangles.size(); ++t) {
      Begin("VERTEX", "AcDbFaceRecord", polyline);
      writer_.PutPoint(10, Eigen::Vector3d::Zero());
      writer_.Put(70, 128);
      for (int corner = 0; corner < 3; ++corner) {
        // Counted from 1; negative if the edge that begins there is invisible.
        const int vertex = part.triangles[t][corner] + 1;
        writer_.Put(71 + corner, part.is_border[t][corner] ? vertex : -vertex);
      }
    }
    Begin("SEQEND", nullptr, polyline);
  }

  const DxfLayerPlan& plan_;
  int model_space_;
  int* next_handle_;
  DxfWriter& writer_;
  std::string layer_;
  std::vector<int> ids_;
  double rod_radius_ = 0;
};

}  // namespace

void PutDxfEntities(const DrawingGraph& graph, const DxfLayerPlan& plan,
                    const std::optional<DxfPlan>& flat_plan, int model_space, int* next_handle,
                    DxfWriter* writer) {
  EntityWriter entities(plan, model_space, next_handle, writer);
  if (flat_plan) {
    const double tolerance = kStraightMm * flat_plan->layout.mm;
    const size_t num_hidden = flat_plan->hidden.graph.links.size();
    entities.PutFlat({graph, flat_plan->ellipses}, plan.of_link, tolerance);
    entities.PutFlat(flat_plan->hidden, std::vector<int>(num_hidden, plan.of_hidden), tolerance);
    entities.PutSection(flat_plan->section);
  } else {
    for (size_t id = 0; id < graph.links.size(); ++id) {
      entities.PutLink(graph.links[id], plan.of_link[id], NumberOfLink(graph, id));
    }
  }
  for (size_t id = 0; id < graph.faces.size(); ++id) {
    for (const TrianglePart& part : PartsOf(graph.faces[id])) {
      entities.PutFace(part, static_cast<int>(id));
    }
  }
  if (plan.of_junctions < 0) return;
  for (size_t id = 0; id < graph.nodes.size(); ++id) {
    if (graph.nodes[id].kind != NodeKind::kJunction) continue;
    entities.PutPoint(graph.nodes[id].position_in_world, plan.of_junctions,
                      NumberOfNode(graph, id));
  }
}

}  // namespace limn
