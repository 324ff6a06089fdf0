#include "limn/formats/json_faces.h"

#include <optional>

#include <nlohmann/json.hpp>

#include "limn/files/json_text.h"
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

Eigen::Vector3d PlaceFromJson(const FaceJson& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

std::vector<Eigen::Vector3d> PlacesFromJson(const FaceJson& json) {
  std::vector<Eigen::Vector3d> places;
  for (const FaceJson& place : json) places.push_back(PlaceFromJson(place));
  return places;
}

FaceJson EdgeToJson(const FaceEdge& edge) {
  if (edge.IsBridge()) return {{"bridge", PlacesToJson(edge.bridge)}};
  return {{"link", edge.link}, {"from", edge.from}, {"to", edge.to}};
}

FaceEdge EdgeFromJson(const FaceJson& json) {
  FaceEdge edge;
  if (json.contains("bridge")) edge.bridge = PlacesFromJson(json.at("bridge"));
  if (!json.contains("bridge") || json.contains("link")) {
    edge.link = IntFromJson(json.at("link"));
    edge.from = json.at("from").get<double>();
    edge.to = json.at("to").get<double>();
  }
  return edge;
}

FaceLoop LoopFromJson(const FaceJson& json) {
  FaceLoop loop;
  for (const FaceJson& edge : json) loop.push_back(EdgeFromJson(edge));
  return loop;
}

FaceSurface SurfaceFromJson(const std::string& name) {
  const std::optional<FaceSurface> surface = FaceSurfaceNamed(name);
  if (!surface) throw InputError("unknown surface of a face \"" + name.substr(0, 40) + "\"");
  return *surface;
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

DrawingFace FaceFromJson(const nlohmann::ordered_json& json,
                         const std::map<std::string, int>& view_ids) {
  DrawingFace face;
  face.surface = SurfaceFromJson(json.at("surface").get<std::string>());
  face.confidence = json.at("confidence").get<double>();
  if (face.surface == FaceSurface::kPlane) {
    face.normal = PlaceFromJson(json.at("normal"));
    face.offset = json.at("offset").get<double>();
  }
  for (const FaceJson& name : json.at("views")) {
    const auto id = view_ids.find(name.get<std::string>());
    if (id == view_ids.end()) throw InputError("a view of a face is not in the list of views");
    face.views.push_back(id->second);
  }
  for (const FaceJson& loop : json.at("loops")) face.loops.push_back(LoopFromJson(loop));
  for (const FaceJson& start : json.value("side_starts", FaceJson::array())) {
    face.side_starts.push_back(IntFromJson(start));
  }
  face.vertices = PlacesFromJson(json.at("vertices"));
  for (const FaceJson& corners : json.at("triangles")) {
    face.triangles.push_back(
        {IntFromJson(corners.at(0)), IntFromJson(corners.at(1)), IntFromJson(corners.at(2))});
  }
  return face;
}

}  // namespace limn
