#include "limn/formats/json_drawing_reader.h"

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <system_error>

#include <nlohmann/json.hpp>

#include "limn/files/json_text.h"
#include "limn/files/whole_file.h"
#include "limn/formats/json_faces.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr const char* kRefinedCameras = "refined_cameras";
// It is before the list of views, which may be long.
constexpr size_t kMaxHeadBytes = 1 << 10;

// Ordered, so that the options come back in the order they were written in.
using Json = nlohmann::ordered_json;

Eigen::Vector3d ToPoint(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

// The one of the values whose name (by SourceName) the file has.
template <typename Source>
Source ToSource(const std::string& name, std::initializer_list<Source> values) {
  for (const Source value : values) {
    if (name == SourceName(value)) return value;
  }
  throw InputError("\"world_from_model\": unknown source \"" + name.substr(0, 40) + "\"");
}

Alignment ToAlignment(const Json& json) {
  Alignment alignment;
  Similarity3d& similarity = alignment.world_from_model;
  similarity.scale = json.at("scale").get<double>();
  for (int row = 0; row < 3; ++row) {
    similarity.rotation.row(row) = ToPoint(json.at("rotation").at(row)).transpose();
  }
  similarity.translation = ToPoint(json.at("translation"));
  alignment.up =
      ToSource(json.at("up_from").get<std::string>(),
               {UpSource::kGravity, UpSource::kPositions, UpSource::kLines, UpSource::kCameras});
  alignment.axes = ToSource(json.at("axes_from").get<std::string>(),
                            {AxesSource::kLines, AxesSource::kPositions, AxesSource::kModel});
  alignment.scale = ToSource(json.at("scale_from").get<std::string>(),
                             {ScaleSource::kNone, ScaleSource::kLengths, ScaleSource::kPositions});
  const std::string broken = Validate(alignment);
  if (!broken.empty()) throw InputError("\"world_from_model\": " + broken);
  if (json.at("unit").get<std::string>() != alignment.Unit()) {
    throw InputError("\"world_from_model\": the unit is not \"" + std::string(alignment.Unit()) +
                     "\"");
  }
  return alignment;
}

LinkEnd ToLinkEnd(const Json& json) { return {IntFromJson(json.at(0)), IntFromJson(json.at(1))}; }

NodeKind ToNodeKind(const std::string& name) {
  for (const NodeKind kind : {NodeKind::kEnd, NodeKind::kJunction, NodeKind::kLoopAnchor}) {
    if (name == NodeKindName(kind)) return kind;
  }
  throw InputError("unknown kind of node \"" + name.substr(0, 40) + "\"");
}

DrawingNode ToNode(const Json& json) {
  DrawingNode node;
  node.position_in_world = ToPoint(json.at("position"));
  node.kind = ToNodeKind(json.at("kind").get<std::string>());
  for (const Json& end : json.at("incident")) node.incident.push_back(ToLinkEnd(end));
  for (const Json& pair : json.at("continuations")) {
    node.continuations.emplace_back(ToLinkEnd(pair.at(0)), ToLinkEnd(pair.at(1)));
  }
  return node;
}

LinkDense ToDense(const Json& json) {
  LinkDense dense;
  const auto name = json.at("class").get<std::string>();
  for (const DenseClass candidate :
       {DenseClass::kUnknown, DenseClass::kSurface, DenseClass::kBoundary, DenseClass::kFree}) {
    if (name == DenseClassName(candidate)) dense.dense_class = candidate;
  }
  if (name != DenseClassName(dense.dense_class)) {
    throw InputError("unknown class of link \"" + name.substr(0, 40) + "\"");
  }
  dense.added_share = json.at("added_share").get<double>();
  dense.occluded_share = json.at("occluded_share").get<double>();
  dense.behind_surface = json.at("behind_surface").get<bool>();
  dense.fold_deg = json.value("fold_deg", -1.0);
  return dense;
}

CircularArc ToArc(const Json& json) {
  CircularArc arc;
  arc.center = ToPoint(json.at("center"));
  arc.x_axis = ToPoint(json.at("x_axis"));
  arc.y_axis = ToPoint(json.at("y_axis"));
  arc.radius = json.at("radius").get<double>();
  arc.sweep_rad = json.at("sweep_rad").get<double>();
  return arc;
}

CubicBSpline ToSpline(const Json& json) {
  CubicBSpline spline;
  spline.knots = json.at("knots").get<std::vector<double>>();
  for (const Json& point : json.at("control_points")) {
    spline.control_points.push_back(ToPoint(point));
  }
  return spline;
}

LinkPrimitive ToPrimitive(const Json& json) {
  LinkPrimitive primitive;
  const auto type = json.at("type").get<std::string>();
  if (type == "line") {
    primitive.shape = LineSegment{ToPoint(json.at("start")), ToPoint(json.at("end"))};
  } else if (type == "arc" || type == "circle") {
    primitive.shape = ToArc(json);
  } else if (type == "spline") {
    primitive.shape = ToSpline(json);
  } else {
    throw InputError("unknown type of primitive \"" + type.substr(0, 40) + "\"");
  }
  primitive.rms_px = json.at("rms_px").get<double>();
  primitive.max_px = json.at("max_px").get<double>();
  return primitive;
}

RoundBody ToRoundBody(const Json& json) {
  RoundBody body;
  const auto name = json.at("shape").get<std::string>();
  const std::optional<RoundShape> shape = RoundShapeNamed(name);
  if (!shape) throw InputError("unknown shape of a body \"" + name.substr(0, 40) + "\"");
  body.shape = *shape;
  if (body.shape == RoundShape::kSphere) {
    body.start = body.end = ToPoint(json.at("center"));
    body.start_radius = body.end_radius = json.at("radius").get<double>();
  } else {
    body.start = ToPoint(json.at("axis").at(0));
    body.end = ToPoint(json.at("axis").at(1));
    body.start_radius = json.at("radii").at(0).get<double>();
    body.end_radius = json.at("radii").at(1).get<double>();
  }
  body.radius_sigma = json.at("radius_sigma").get<double>();
  body.rms_px = json.at("rms_px").get<double>();
  return body;
}

LinkRegularity ToLinkRegularity(const Json& json) {
  const auto index = [&](const char* name) {
    return json.contains(name) ? IntFromJson(json.at(name)) : -1;
  };
  LinkRegularity regularity;
  regularity.direction = index("direction");
  regularity.radius = index("radius");
  regularity.axis = index("axis");
  for (const Json& plane : json.value("planes", Json::array())) {
    regularity.planes.push_back(IntFromJson(plane));
  }
  return regularity;
}

Regularities ToRegularities(const Json& json) {
  Regularities regularities;
  for (const Json& of : json.at("directions")) {
    regularities.directions.push_back({ToPoint(of.at("direction")), {}});
    for (const Json& other : of.at("orthogonal_to")) {
      regularities.directions.back().orthogonal_to.push_back(IntFromJson(other));
    }
  }
  for (const Json& of : json.at("planes")) {
    const int normal =
        of.contains("normal_direction") ? IntFromJson(of.at("normal_direction")) : -1;
    regularities.planes.push_back(
        {ToPoint(of.at("normal")), of.at("offset").get<double>(), normal});
  }
  regularities.radii = json.at("radii").get<std::vector<double>>();
  for (const Json& of : json.at("axes")) {
    regularities.axes.push_back({ToPoint(of.at("point")), ToPoint(of.at("direction"))});
  }
  const std::string broken = Validate(regularities);
  if (!broken.empty()) throw InputError("\"regularities\": " + broken);
  return regularities;
}

// Drawings of earlier versions have no kinds.
LinkKind ToKind(const std::string& name) {
  const std::optional<LinkKind> kind = LinkKindNamed(name);
  if (!kind) throw InputError("unknown kind of link \"" + name.substr(0, 40) + "\"");
  return *kind;
}

LinkDoubt ToDoubt(const std::string& name) {
  const std::optional<LinkDoubt> doubt = LinkDoubtNamed(name);
  if (!doubt) throw InputError("unknown doubt of a link \"" + name.substr(0, 40) + "\"");
  return *doubt;
}

DrawingLink ToLink(const Json& json, const std::map<std::string, ViewId>& view_ids) {
  DrawingLink link;
  link.node0 = IntFromJson(json.at("node0"));
  link.node1 = IntFromJson(json.at("node1"));
  link.closed = json.at("closed").get<bool>();
  link.residual_px = json.at("residual_px").get<double>();
  link.tri_angle_deg = json.value("tri_angle_deg", -1.0);
  link.depth_sigma = json.value("depth_sigma", -1.0);
  link.curve_px = json.value("curve_px", 0.0);
  if (json.contains("evidence")) link.evidence = json.at("evidence").get<double>();
  link.confidence = json.value("confidence", -1.0);
  link.kind = ToKind(json.value("kind", "unknown"));
  link.kind_confidence = json.value("kind_confidence", 0.0);
  link.rod_radius = json.value("rod_radius", 0.0);
  if (json.contains("body")) link.body = ToRoundBody(json.at("body"));
  link.tentative = json.value("tentative", false);
  link.doubt = ToDoubt(json.value("doubt", ""));
  if (json.contains("dense")) link.dense = ToDense(json.at("dense"));
  if (json.contains("primitive")) link.primitive = ToPrimitive(json.at("primitive"));
  if (json.contains("regularity")) link.regularity = ToLinkRegularity(json.at("regularity"));
  for (const Json& point : json.at("points")) link.points_in_world.push_back(ToPoint(point));
  for (const Json& sigma : json.at("sigma")) {
    // JSON has no infinity: unknown is null.
    link.sigma.push_back(sigma.is_null() ? std::numeric_limits<double>::infinity()
                                         : sigma.get<double>());
  }
  for (const Json& name : json.at("supporting_views")) {
    const auto id = view_ids.find(name.get<std::string>());
    if (id == view_ids.end()) throw InputError("supporting view is not in the list of views");
    link.supporting_views.push_back(id->second);
  }
  for (const Json& member : json.at("members")) {
    link.members.push_back(
        {IntFromJson(member.at(0)), IntFromJson(member.at(1)), IntFromJson(member.at(2))});
  }
  return link;
}

DrawingFile ToDrawingFile(const Json& json) {
  if (json.at("format").get<std::string>() != kDrawingJsonFormat) {
    throw InputError("\"format\" is not \"" + std::string(kDrawingJsonFormat) + "\"");
  }
  const int version = IntFromJson(json.at("format_version"));
  if (version != kDrawingJsonVersion) {
    throw InputError("format version " + std::to_string(version) + "; this program reads version " +
                     std::to_string(kDrawingJsonVersion));
  }
  DrawingFile file;
  std::map<std::string, ViewId> view_ids;
  for (const Json& name : json.at("views")) {
    file.metadata.view_names.push_back(name.get<std::string>());
    const auto id = static_cast<ViewId>(view_ids.size());
    if (!view_ids.emplace(file.metadata.view_names.back(), id).second) {
      throw InputError("view \"" + file.metadata.view_names.back() + "\" is listed twice");
    }
  }
  if (!json.at("options").is_object()) throw InputError("\"options\" is not an object");
  file.metadata.options_json = json.at("options").dump();
  file.metadata.refined_cameras = json.value(kRefinedCameras, "");
  if (json.contains("world_from_model")) {
    file.metadata.alignment = ToAlignment(json.at("world_from_model"));
  }
  if (json.contains("regularities")) {
    file.graph.regularities = ToRegularities(json.at("regularities"));
  }
  for (const Json& dimension : json.value("dimensions", Json::array())) {
    file.graph.dimensions.push_back({ToPoint(dimension.at("from")), ToPoint(dimension.at("to")),
                                     ToPoint(dimension.at("shift"))});
  }
  for (const Json& node : json.at("nodes")) file.graph.nodes.push_back(ToNode(node));
  for (const Json& link : json.at("links")) file.graph.links.push_back(ToLink(link, view_ids));
  for (const Json& face : json.value("faces", Json::array())) {
    file.graph.faces.push_back(FaceFromJson(face, view_ids));
  }
  const std::vector<std::string> violations = Validate(file.graph);
  if (!violations.empty()) throw InputError("no valid drawing: " + violations.front());
  return file;
}

}  // namespace

DrawingFile ParseDrawingJson(const std::string& name, const std::string& text) {
  try {
    return ToDrawingFile(ParseJson(name, text));
  } catch (const std::exception&) {
    RethrowJsonError(name);
  }
}

DrawingFile ReadDrawingJson(const std::string& path) {
  return ParseDrawingJson(path, ReadWholeFile(path, kMaxDrawingBytes));
}

std::string RefinedCamerasOfDrawing(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return "";
  std::string head(kMaxHeadBytes, ' ');
  std::ifstream in = OpenFile(path);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  const std::string key = std::string("\"") + kRefinedCameras + "\": \"";
  const size_t at = head.find(key);
  if (at == std::string::npos) return "";
  const size_t begin = at + key.size();
  return head.substr(begin, head.find('"', begin) - begin);
}

}  // namespace limn
