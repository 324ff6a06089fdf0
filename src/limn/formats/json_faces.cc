// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/json_faces.h"

#include <nlohmann/json.hpp>

#include "limn/formats/json_place.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using FaceJson = nlohmann::ordered_json;

FaceJson PlaceToJson(const Eigen::Vector3d& place) { return {place.x(), place.y(), place.z()}; }

FaceJson PlacesToJson(const std::vector<Eigen::Vector3d>& places) {
  FaceJson json = FaceJson::array();
  for (const Eigen::Vector3d& place : places) json.push_back(PlaceToJson(place));
  return json;
}

FaceJson EdgeToJson(const FaceEdge& edge) {
  if (edge.IsBridge()) return {{"bridge", PlacesToJson(edge.bridge)}};
  return {{"link", edge.link}, {"from", edge.from}, {"to", edge.to}};
}

FaceEdge EdgeFromJson(const JsonValue& value) {
  FaceEdge edge;
  const auto bridge = value.Find("bridge");
  if (bridge) edge.bridge = PlacesOf(*bridge);
  if (!bridge || value.Find("link")) {
    edge.link = value.At("link").Integer();
    edge.from = value.At("from").Number();
    edge.to = value.At("to").Number();
  }
  return edge;
}

FaceLoop LoopFromJson(const JsonValue& value) {
  FaceLoop loop;
  for (const JsonValue& edge : value.Items()) loop.push_back(EdgeFromJson(edge));
  return loop;
}

}  // namespace

nlohmann::ordered_json FaceToJson(const DrawingFace& face, size_t id,
                                  const std::vector<std::string>& view_names) {
  FaceJson json = {{"id", id},
                   {"surface", FaceSurfaceName(face.surface)},
                   {"area", AreaOf(face)},
                   {"confidence", face.confidence}};
  if (face.surface == FaceSurface::kPlane) {
    json["normal"] = PlaceToJson(face.normal);
    json["offset"] = face.offset;
  }
  json["views"] = FaceJson::array();
  for (const int view : face.views) {
    if (view < 0 || view >= static_cast<int>(view_names.size())) {
      throw InputError("face " + std::to_string(id) + ": view " + std::to_string(view) +
                       " has no name");
    }
    json["views"].push_back(view_names[view]);
  }
  json["loops"] = FaceJson::array();
  for (const FaceLoop& loop : face.loops) {
    FaceJson edges = FaceJson::array();
    for (const FaceEdge& edge : loop) edges.push_back(EdgeToJson(edge));
    json["loops"].push_back(std::move(edges));
  }
  if (!face.side_starts.empty()) json["side_starts"] = face.side_starts;
  json["vertices"] = PlacesToJson(face.vertices);
  json["triangles"] = face.triangles;
  return json;
}

DrawingFace FaceFromJson(const JsonValue& value, const JsonViewIds& view_ids) {
  DrawingFace face;
  face.surface = NamedBy(value.At("surface"), FaceSurfaceNamed, "surface of a face");
  face.confidence = value.At("confidence").Number();
  if (face.surface == FaceSurface::kPlane) {
    face.normal = PlaceOf(value.At("normal"));
    face.offset = value.At("offset").Number();
  }
  face.views = ViewsOf(value.At("views"), view_ids);
  for (const JsonValue& loop : value.At("loops").Items()) face.loops.push_back(LoopFromJson(loop));
  for (const JsonValue& start : value.ItemsOf("side_starts")) {
    face.side_starts.push_back(start.Integer());
  }
  face.vertices = PlacesOf(value.At("vertices"));
  for (const JsonValue& triangle : value.At("triangles").Items()) {
    const std::vector<JsonValue> corners = triangle.Items(3, 3);
    face.triangles.push_back({corners[0].Integer(), corners[1].Integer(), corners[2].Integer()});
  }
  return face;
}

}  // namespace limn
