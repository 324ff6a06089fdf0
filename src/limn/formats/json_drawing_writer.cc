// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/json_drawing_writer.h"

#include <cmath>
#include <ostream>
#include <variant>

#include <nlohmann/json.hpp>

#include "limn/files/json_text.h"
#include "limn/files/json_value.h"
#include "limn/formats/json_faces.h"
#include "limn/geometry/polyline.h"
#include "limn/model/drawing_paths.h"
#include "limn/util/errors.h"
#include "limn/version.h"

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

Json ToJson(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

Json ToJson(const Alignment& alignment) {
  const auto& [scale, rotation, translation] = alignment.world_from_model;
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row) rows.push_back(ToJson(rotation.row(row).transpose().eval()));
  Json json = {{"scale", scale},
               {"rotation", rows},
               {"translation", ToJson(translation)},
               {"unit", alignment.Unit()},
               {"up_from", SourceName(alignment.up)},
               {"axes_from", SourceName(alignment.axes)},
               {"scale_from", SourceName(alignment.scale)}};
  if (alignment.scale_sigma > 0) json["scale_sigma"] = alignment.scale_sigma;
  return json;
}

Json UpperTriangle(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
}

Json ToJson(const LinkEnd& end) { return {end.link, end.end}; }

Json ToJson(const DrawingNode& node, size_t id) {
  Json json = {{"id", id},
               {"position", ToJson(node.position_in_world)},
               {"kind", NodeKindName(node.kind)},
               {"degree", node.Degree()}};
  const double largest = node.covariance.cwiseAbs().maxCoeff();
  if (largest > 0 && largest <= JsonValue::kMaxNumber)
    json["covariance"] = UpperTriangle(node.covariance);
  json["incident"] = Json::array();
  for (const LinkEnd& end : node.incident) json["incident"].push_back(ToJson(end));
  json["continuations"] = Json::array();
  for (const auto& [first, second] : node.continuations) {
    json["continuations"].push_back(Json::array({ToJson(first), ToJson(second)}));
  }
  return json;
}

Json ToJson(const LinkDense& dense) {
  Json json = {{"class", DenseClassName(dense.dense_class)},
               {"added_share", dense.added_share},
               {"occluded_share", dense.occluded_share},
               {"behind_surface", dense.behind_surface}};
  if (dense.fold_deg >= 0) json["fold_deg"] = dense.fold_deg;
  return json;
}

Json ToJson(const LinkPrimitive& primitive) {
  Json json = {{"type", ShapeName(primitive.shape)}};
  if (const auto* line = std::get_if<LineSegment>(&primitive.shape)) {
    json["start"] = ToJson(line->start);
    json["end"] = ToJson(line->end);
  } else if (const auto* arc = std::get_if<CircularArc>(&primitive.shape)) {
    json["center"] = ToJson(arc->center);
    json["x_axis"] = ToJson(arc->x_axis);
    json["y_axis"] = ToJson(arc->y_axis);
    json["radius"] = arc->radius;
    json["sweep_rad"] = arc->sweep_rad;
  } else if (const auto* spline = std::get_if<CubicBSpline>(&primitive.shape)) {
    json["degree"] = 3;
    json["knots"] = spline->knots;
    for (const Eigen::Vector3d& point : spline->control_points) {
      json["control_points"].push_back(ToJson(point));
    }
  }
  json["rms_px"] = primitive.rms_px;
  json["max_px"] = primitive.max_px;
  return json;
}

Json ToJson(const RoundBody& body) {
  Json json = {{"shape", RoundShapeName(body.shape)}};
  if (body.shape == RoundShape::kSphere) {
    json["center"] = ToJson(body.start);
    json["radius"] = body.start_radius;
  } else {
    json["axis"] = Json::array({ToJson(body.start), ToJson(body.end)});
    json["radii"] = {body.start_radius, body.end_radius};
  }
  json["radius_sigma"] = body.radius_sigma;
  json["rms_px"] = body.rms_px;
  return json;
}

Json ToJson(const LinkRegularity& regularity) {
  Json json = Json::object();
  if (regularity.direction >= 0) json["direction"] = regularity.direction;
  if (!regularity.planes.empty()) json["planes"] = regularity.planes;
  if (regularity.radius >= 0) json["radius"] = regularity.radius;
  if (regularity.axis >= 0) json["axis"] = regularity.axis;
  return json;
}

Json ToJson(const Regularities& regularities) {
  Json directions = Json::array(), planes = Json::array(), axes = Json::array();
  for (const CommonDirection& of : regularities.directions) {
    directions.push_back(
        {{"direction", ToJson(of.direction)}, {"orthogonal_to", of.orthogonal_to}});
  }
  for (const CommonPlane& of : regularities.planes) {
    planes.push_back({{"normal", ToJson(of.normal)}, {"offset", of.offset}});
    if (of.normal_direction >= 0) planes.back()["normal_direction"] = of.normal_direction;
  }
  for (const CommonAxis& of : regularities.axes) {
    axes.push_back({{"point", ToJson(of.point)}, {"direction", ToJson(of.direction)}});
  }
  return {{"directions", directions},
          {"planes", planes},
          {"radii", regularities.radii},
          {"axes", axes}};
}

Json ToJson(const DrawingDimension& dimension) {
  return {{"from", ToJson(dimension.from)},
          {"to", ToJson(dimension.to)},
          {"shift", ToJson(dimension.shift)}};
}

Json ToJson(const DrawingLink& link, size_t id, LinkId curve,
            const std::vector<std::string>& view_names) {
  Json json = {{"id", id},
               {"curve", curve},
               {"node0", link.node0},
               {"node1", link.node1},
               {"closed", link.closed},
               {"length", Length(link.points_in_world)},
               {"residual_px", link.residual_px}};
  if (link.tri_angle_deg >= 0) json["tri_angle_deg"] = link.tri_angle_deg;
  if (link.depth_sigma >= 0 && link.depth_sigma <= JsonValue::kMaxNumber) {
    json["depth_sigma"] = link.depth_sigma;
  }
  if (link.curve_px > 0) json["curve_px"] = link.curve_px;
  if (link.evidence) json["evidence"] = *link.evidence;
  if (link.confidence >= 0) json["confidence"] = link.confidence;
  json["kind"] = LinkKindName(link.kind);
  if (link.kind != LinkKind::kUnknown) json["kind_confidence"] = link.kind_confidence;
  if (link.kind == LinkKind::kRod) json["rod_radius"] = link.rod_radius;
  if (link.body) json["body"] = ToJson(*link.body);
  if (link.tentative) json["tentative"] = true;
  if (link.doubt != LinkDoubt::kNone) json["doubt"] = LinkDoubtName(link.doubt);
  if (link.dense) json["dense"] = ToJson(*link.dense);
  if (link.primitive) json["primitive"] = ToJson(*link.primitive);
  if (link.regularity) json["regularity"] = ToJson(*link.regularity);
  json["supporting_views"] = Json::array();
  for (const ViewId view : link.supporting_views) {
    if (view < 0 || view >= static_cast<ViewId>(view_names.size())) {
      throw InputError("link " + std::to_string(id) + ": supporting view " + std::to_string(view) +
                       " has no name");
    }
    json["supporting_views"].push_back(view_names[view]);
  }
  json["members"] = Json::array();
  for (const LinkMember& member : link.members) {
    json["members"].push_back({member.curve, member.begin, member.end});
  }
  json["points"] = Json::array();
  for (const Eigen::Vector3d& point : link.points_in_world) json["points"].push_back(ToJson(point));
  json["sigma"] = Json::array();
  for (const double sigma : link.sigma) {
    json["sigma"].push_back(sigma <= JsonValue::kMaxNumber ? Json(sigma) : Json(nullptr));
  }
  return json;
}

Json ParseOptions(const std::string& text) {
  const Json options = ParseJson("options of the drawing", text);
  if (!options.is_object()) throw InputError("the options of a drawing must be a JSON object");
  return options;
}

template <typename Items, typename AsJson>
void PutList(const char* name, const Items& items, const AsJson& as_json, std::ostream& out) {
  out << '"' << name << "\": [";
  for (size_t id = 0; id < items.size(); ++id) {
    out << (id == 0 ? "\n" : ",\n") << as_json(items[id], id).dump();
  }
  out << "\n]";
}

}  // namespace

void WriteDrawingJson(const DrawingGraph& graph, const DrawingMetadata& metadata,
                      std::ostream& out) {
  out << "{\"format\": \"" << kDrawingJsonFormat
      << "\",\n\"format_version\": " << kDrawingJsonVersion
      << ",\n\"limn_version\": \"" LIMN_VERSION "\",\n";
  if (!metadata.refined_cameras.empty()) {
    out << "\"refined_cameras\": " << Json(metadata.refined_cameras).dump() << ",\n";
  }
  out << "\"views\": " << Json(metadata.view_names).dump()
      << ",\n\"options\": " << ParseOptions(metadata.options_json).dump() << ",\n";
  if (metadata.alignment) {
    out << "\"world_from_model\": " << ToJson(*metadata.alignment).dump() << ",\n";
  }
  if (metadata.main_view_direction) {
    out << "\"main_view_direction\": " << ToJson(*metadata.main_view_direction).dump() << ",\n";
  }
  if (!graph.regularities.IsEmpty()) {
    out << "\"regularities\": " << ToJson(graph.regularities).dump() << ",\n";
  }
  if (!graph.dimensions.empty()) {
    PutList(
        "dimensions", graph.dimensions,
        [](const DrawingDimension& dimension, size_t) { return ToJson(dimension); }, out);
    out << ",\n";
  }
  PutList(
      "nodes", graph.nodes, [](const DrawingNode& node, size_t id) { return ToJson(node, id); },
      out);
  out << ",\n";
  const std::vector<LinkId> curves = CurvesOf(graph);
  PutList(
      "links", graph.links,
      [&](const DrawingLink& link, size_t id) {
        return ToJson(link, id, curves[id], metadata.view_names);
      },
      out);
  if (!graph.faces.empty()) {
    out << ",\n";
    PutList(
        "faces", graph.faces,
        [&](const DrawingFace& face, size_t id) {
          return FaceToJson(face, id, metadata.view_names);
        },
        out);
  }
  out << "}\n";
}

}  // namespace limn
