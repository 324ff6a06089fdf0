#include "limn/formats/dxf/entities.h"

#include <cmath>
#include <span>
#include <variant>

#include <Eigen/Geometry>

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

  void PutLink(const DrawingLink& link, LinkId id) {
    SetMarks(plan_.of_link[id], id, link.rod_radius);
    if (link.primitive) {
      std::visit([this](const auto& shape) { Put(shape); }, link.primitive->shape);
    } else {
      const bool closed = link.node0 == link.node1;
      PutPolyline(std::span(link.points_in_world).first(link.size() - (closed ? 1 : 0)), closed);
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

  void PutLine(const Polyline3d& points, bool closed, int layer, int id) {
    SetMarks(layer, id);
    PutPolyline(points, closed);
  }

  void PutPlan(const DxfPlan& plan) {
    for (size_t i = 0; i < plan.hidden.size(); ++i) {
      PutLine(plan.hidden[i], false, plan_.of_hidden, static_cast<int>(i));
    }
    const Section& section = plan.section;
    for (size_t i = 0; i < section.lines.size(); ++i) {
      PutLine(section.lines[i].points, section.lines[i].closed, plan_.of_section,
              static_cast<int>(i));
    }
    for (size_t i = 0; i < section.points.size(); ++i) {
      PutPoint(section.points[i], plan_.of_section_points, static_cast<int>(i));
    }
  }

 private:
  // Of the entity that is put next.
  void SetMarks(int layer, int id, double rod_radius = 0) {
    layer_ = plan_.layers[layer].name;
    id_ = id;
    rod_radius_ = rod_radius;
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
    writer_.Put(1071, id_);
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
  int id_ = 0;
  double rod_radius_ = 0;
};

}  // namespace

void PutDxfEntities(const DrawingGraph& graph, const DxfLayerPlan& plan,
                    const std::optional<DxfPlan>& flat_plan, int model_space, int* next_handle,
                    DxfWriter* writer) {
  EntityWriter entities(plan, model_space, next_handle, writer);
  for (size_t id = 0; id < graph.links.size(); ++id) {
    entities.PutLink(graph.links[id], static_cast<LinkId>(id));
  }
  for (size_t id = 0; id < graph.faces.size(); ++id) {
    for (const TrianglePart& part : PartsOf(graph.faces[id])) {
      entities.PutFace(part, static_cast<int>(id));
    }
  }
  if (flat_plan) entities.PutPlan(*flat_plan);
  if (plan.of_junctions < 0) return;
  for (size_t id = 0; id < graph.nodes.size(); ++id) {
    if (graph.nodes[id].kind != NodeKind::kJunction) continue;
    entities.PutPoint(graph.nodes[id].position_in_world, plan.of_junctions,
                      static_cast<NodeId>(id));
  }
}

}  // namespace limn
