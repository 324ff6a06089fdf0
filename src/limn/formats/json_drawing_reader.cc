// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/json_drawing_reader.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <optional>
#include <system_error>

#include <nlohmann/json.hpp>

#include "limn/files/json_text.h"
#include "limn/files/json_value.h"
#include "limn/files/whole_file.h"
#include "limn/formats/json_faces.h"
#include "limn/formats/json_place.h"
#include "limn/formats/json_views.h"
#include "limn/util/errors.h"
#include "limn/util/printable.h"

namespace limn {
namespace {

constexpr const char* kRefinedCameras = "refined_cameras";
// It is before the list of views, which may be long.
constexpr size_t kMaxHeadBytes = 1 << 10;

// The one of the values whose name (by SourceName) the file has.
template <typename Source>
Source ToSource(const JsonValue& value, std::initializer_list<Source> sources) {
  for (const Source source : sources) {
    if (value.Text() == SourceName(source)) return source;
  }
  value.FailUnknown("source");
}

Alignment ToAlignment(const JsonValue& value) {
  Alignment alignment;
  Similarity3d& similarity = alignment.world_from_model;
  similarity.scale = value.At("scale").Number();
  const std::vector<JsonValue> rows = value.At("rotation").Items(3, 3);
  for (int row = 0; row < 3; ++row) similarity.rotation.row(row) = PlaceOf(rows[row]).transpose();
  similarity.translation = PlaceOf(value.At("translation"));
  alignment.up = ToSource(value.At("up_from"), {UpSource::kGravity, UpSource::kPositions,
                                                UpSource::kLines, UpSource::kCameras});
  alignment.axes = ToSource(value.At("axes_from"), {AxesSource::kLines, AxesSource::kPositions,
                                                    AxesSource::kModel, AxesSource::kPlan});
  alignment.scale = ToSource(value.At("scale_from"),
                             {ScaleSource::kNone, ScaleSource::kLengths, ScaleSource::kPositions});
  alignment.scale_sigma = value.NumberOr("scale_sigma", 0);
  const std::string broken = Validate(alignment);
  if (!broken.empty()) value.Fail(broken);
  if (value.At("unit").Text() != alignment.Unit()) {
    value.At("unit").Fail("not \"" + std::string(alignment.Unit()) + "\"");
  }
  return alignment;
}

Eigen::Vector3d ToDirection(const JsonValue& value) {
  const Eigen::Vector3d direction = PlaceOf(value);
  if (!(std::abs(direction.norm() - 1) < 1e-6)) value.Fail("a unit vector expected");
  return direction;
}

LinkEnd ToLinkEnd(const JsonValue& value) {
  const std::vector<JsonValue> items = value.Items(2, 2);
  return {items[0].Integer(), items[1].Integer()};
}

std::optional<NodeKind> NodeKindNamed(const std::string& name) {
  for (const NodeKind kind : {NodeKind::kEnd, NodeKind::kJunction, NodeKind::kLoopAnchor}) {
    if (name == NodeKindName(kind)) return kind;
  }
  return std::nullopt;
}

Eigen::Matrix3d FromUpperTriangle(const JsonValue& value) {
  std::array<double, 6> t;
  value.Numbers(t.size(), t.data());
  Eigen::Matrix3d matrix;
  matrix << t[0], t[1], t[2], t[1], t[3], t[4], t[2], t[4], t[5];
  return matrix;
}

DrawingNode ToNode(const JsonValue& value) {
  DrawingNode node;
  node.position_in_world = PlaceOf(value.At("position"));
  node.kind = NamedBy(value.At("kind"), NodeKindNamed, "kind of node");
  if (const auto covariance = value.Find("covariance")) {
    node.covariance = FromUpperTriangle(*covariance);
  }
  for (const JsonValue& end : value.At("incident").Items()) node.incident.push_back(ToLinkEnd(end));
  for (const JsonValue& pair : value.At("continuations").Items()) {
    const std::vector<JsonValue> ends = pair.Items(2, 2);
    node.continuations.emplace_back(ToLinkEnd(ends[0]), ToLinkEnd(ends[1]));
  }
  return node;
}

std::optional<DenseClass> DenseClassNamed(const std::string& name) {
  for (const DenseClass candidate :
       {DenseClass::kUnknown, DenseClass::kSurface, DenseClass::kBoundary, DenseClass::kFree}) {
    if (name == DenseClassName(candidate)) return candidate;
  }
  return std::nullopt;
}

LinkDense ToDense(const JsonValue& value) {
  LinkDense dense;
  dense.dense_class = NamedBy(value.At("class"), DenseClassNamed, "class of link");
  dense.added_share = value.At("added_share").Number();
  dense.occluded_share = value.At("occluded_share").Number();
  dense.behind_surface = value.At("behind_surface").Bool();
  dense.fold_deg = value.NumberOr("fold_deg", -1);
  return dense;
}

CircularArc ToArc(const JsonValue& value) {
  CircularArc arc;
  arc.center = PlaceOf(value.At("center"));
  arc.x_axis = PlaceOf(value.At("x_axis"));
  arc.y_axis = PlaceOf(value.At("y_axis"));
  arc.radius = value.At("radius").Number();
  arc.sweep_rad = value.At("sweep_rad").Number();
  return arc;
}

LinkPrimitive ToPrimitive(const JsonValue& value) {
  LinkPrimitive primitive;
  const std::string& type = value.At("type").Text();
  if (type == "line") {
    primitive.shape = LineSegment{PlaceOf(value.At("start")), PlaceOf(value.At("end"))};
  } else if (type == "arc" || type == "circle") {
    primitive.shape = ToArc(value);
  } else if (type == "spline") {
    primitive.shape =
        CubicBSpline{value.At("knots").Numbers(), PlacesOf(value.At("control_points"))};
  } else {
    value.At("type").FailUnknown("type of primitive");
  }
  primitive.rms_px = value.At("rms_px").Number();
  primitive.max_px = value.At("max_px").Number();
  return primitive;
}

RoundBody ToRoundBody(const JsonValue& value) {
  RoundBody body;
  body.shape = NamedBy(value.At("shape"), RoundShapeNamed, "shape of a body");
  if (body.shape == RoundShape::kSphere) {
    body.start = body.end = PlaceOf(value.At("center"));
    body.start_radius = body.end_radius = value.At("radius").Number();
  } else {
    const std::vector<JsonValue> axis = value.At("axis").Items(2, 2);
    const std::vector<JsonValue> radii = value.At("radii").Items(2, 2);
    body.start = PlaceOf(axis[0]);
    body.end = PlaceOf(axis[1]);
    body.start_radius = radii[0].Number();
    body.end_radius = radii[1].Number();
  }
  body.radius_sigma = value.At("radius_sigma").Number();
  body.rms_px = value.At("rms_px").Number();
  return body;
}

std::vector<int> IntegersOf(const std::vector<JsonValue>& items) {
  std::vector<int> integers;
  for (const JsonValue& item : items) integers.push_back(item.Integer());
  return integers;
}

// -1 if there is none.
int IndexOf(const JsonValue& value, const char* name) {
  const auto found = value.Find(name);
  return found ? found->Integer() : -1;
}

LinkRegularity ToLinkRegularity(const JsonValue& value) {
  LinkRegularity regularity;
  regularity.direction = IndexOf(value, "direction");
  regularity.radius = IndexOf(value, "radius");
  regularity.axis = IndexOf(value, "axis");
  regularity.planes = IntegersOf(value.ItemsOf("planes"));
  return regularity;
}

Regularities ToRegularities(const JsonValue& value) {
  Regularities regularities;
  for (const JsonValue& of : value.At("directions").Items()) {
    regularities.directions.push_back(
        {PlaceOf(of.At("direction")), IntegersOf(of.At("orthogonal_to").Items())});
  }
  for (const JsonValue& of : value.At("planes").Items()) {
    regularities.planes.push_back(
        {PlaceOf(of.At("normal")), of.At("offset").Number(), IndexOf(of, "normal_direction")});
  }
  regularities.radii = value.At("radii").Numbers();
  for (const JsonValue& of : value.At("axes").Items()) {
    regularities.axes.push_back({PlaceOf(of.At("point")), PlaceOf(of.At("direction"))});
  }
  const std::string broken = Validate(regularities);
  if (!broken.empty()) value.Fail(broken);
  return regularities;
}

std::vector<double> ToSigmas(const JsonValue& value) {
  std::vector<double> sigmas;
  for (const JsonValue& sigma : value.Items()) {
    // JSON has no infinity: unknown is null.
    sigmas.push_back(sigma.IsNull() ? std::numeric_limits<double>::infinity() : sigma.Number());
  }
  return sigmas;
}

DrawingLink ToLink(const JsonValue& value, const JsonViewIds& view_ids) {
  DrawingLink link;
  link.node0 = value.At("node0").Integer();
  link.node1 = value.At("node1").Integer();
  link.closed = value.At("closed").Bool();
  link.residual_px = value.At("residual_px").Number();
  link.tri_angle_deg = value.NumberOr("tri_angle_deg", -1);
  link.depth_sigma = value.NumberOr("depth_sigma", -1);
  link.curve_px = value.NumberOr("curve_px", 0);
  if (const auto evidence = value.Find("evidence")) link.evidence = evidence->Number();
  link.confidence = value.NumberOr("confidence", -1);
  // Drawings of earlier versions have no kinds.
  if (const auto kind = value.Find("kind"))
    link.kind = NamedBy(*kind, LinkKindNamed, "kind of link");
  link.kind_confidence = value.NumberOr("kind_confidence", 0);
  link.rod_radius = value.NumberOr("rod_radius", 0);
  if (const auto body = value.Find("body")) link.body = ToRoundBody(*body);
  link.tentative = value.BoolOr("tentative", false);
  if (const auto doubt = value.Find("doubt")) {
    link.doubt = NamedBy(*doubt, LinkDoubtNamed, "doubt of a link");
  }
  if (const auto dense = value.Find("dense")) link.dense = ToDense(*dense);
  if (const auto primitive = value.Find("primitive")) link.primitive = ToPrimitive(*primitive);
  if (const auto regularity = value.Find("regularity")) {
    link.regularity = ToLinkRegularity(*regularity);
  }
  link.points_in_world = PlacesOf(value.At("points"));
  link.sigma = ToSigmas(value.At("sigma"));
  link.supporting_views = ViewsOf(value.At("supporting_views"), view_ids);
  for (const JsonValue& member : value.At("members").Items()) {
    const std::vector<JsonValue> items = member.Items(3, 3);
    link.members.push_back({items[0].Integer(), items[1].Integer(), items[2].Integer()});
  }
  return link;
}

void CheckFormat(const JsonValue& file) {
  const JsonValue format = file.At("format");
  if (format.Text() != kDrawingJsonFormat) {
    format.Fail("not \"" + std::string(kDrawingJsonFormat) + "\"");
  }
  const int version = file.At("format_version").Integer();
  if (version == kDrawingJsonVersion) return;
  throw InputError("format version " + std::to_string(version) + "; this program reads version " +
                   std::to_string(kDrawingJsonVersion));
}

// Takes nodes, links and faces as they are read, so that not all of a large file is in memory.
class DrawingReader {
 public:
  // Of a list of the file; links and faces only if the views are known.
  bool Take(const std::string& list, const JsonValue& item) {
    if (list != "nodes" && list != "links" && list != "faces") return false;
    if (!has_views_) ReadHead(item.Root());
    if (list != "nodes" && !has_views_) return false;
    Add(list, item);
    return true;
  }

  // After them the others.
  DrawingFile Finish(const JsonValue& root) {
    CheckFormat(root);
    root.At("views");
    if (!has_views_) ReadHead(root);  // they were after the links
    ReadMetadata(root);
    for (const char* list : {"nodes", "links"}) root.At(list).Items();
    for (const char* list : {"nodes", "links", "faces"}) {
      for (const JsonValue& item : root.ItemsOf(list)) {
        if (!item.IsNull()) Add(list, item);
      }
    }
    const std::vector<std::string> violations = Validate(file_.graph);
    if (!violations.empty()) throw InputError("no valid drawing: " + violations.front());
    return std::move(file_);
  }

 private:
  void Add(const std::string& list, const JsonValue& item) {
    DrawingGraph& graph = file_.graph;
    if (list == "nodes") graph.nodes.push_back(ToNode(item));
    if (list == "links") graph.links.push_back(ToLink(item, view_ids_));
    if (list == "faces") graph.faces.push_back(FaceFromJson(item, view_ids_));
  }

  // What has been read of it.
  void ReadHead(const JsonValue& root) {
    if (root.Find("format") && root.Find("format_version")) CheckFormat(root);
    const auto views = root.Find("views");
    if (!views) return;
    has_views_ = true;
    std::vector<std::string>& names = file_.metadata.view_names;
    for (const JsonValue& name : views->Items()) {
      if (!view_ids_.emplace(name.Text(), static_cast<ViewId>(names.size())).second) {
        name.Fail("view \"" + Printable(name.Text()) + "\" is listed twice");
      }
      names.push_back(name.Text());
    }
  }

  void ReadMetadata(const JsonValue& root) {
    DrawingMetadata& metadata = file_.metadata;
    const JsonValue options = root.At("options");
    options.ExpectObject();
    options.ItemsOf("edits");  // later edits are added to them
    metadata.options_json = options.Json().dump();
    metadata.refined_cameras = root.TextOr(kRefinedCameras, "");
    if (const auto direction = root.Find("main_view_direction")) {
      metadata.main_view_direction = ToDirection(*direction);
    }
    if (const auto alignment = root.Find("world_from_model")) {
      metadata.alignment = ToAlignment(*alignment);
    }
    if (const auto regularities = root.Find("regularities")) {
      file_.graph.regularities = ToRegularities(*regularities);
    }
    for (const JsonValue& dimension : root.ItemsOf("dimensions")) {
      file_.graph.dimensions.push_back({PlaceOf(dimension.At("from")), PlaceOf(dimension.At("to")),
                                        PlaceOf(dimension.At("shift"))});
    }
  }

  DrawingFile file_;
  JsonViewIds view_ids_;
  bool has_views_ = false;
};

}  // namespace

DrawingFile ParseDrawingJson(const std::string& name, const std::string& text) {
  try {
    DrawingReader reader;
    const auto json = ParseJson(
        name, text, kMaxLargeJsonValues,
        [&](const std::string& list, const JsonValue& item) { return reader.Take(list, item); });
    return reader.Finish(JsonValue(json));
  } catch (const std::exception&) {
    RethrowJsonError(name);
  }
}

DrawingMetadata After(const Similarity3d& file_from_model, DrawingMetadata metadata) {
  if (metadata.alignment) metadata.alignment = After(file_from_model, *metadata.alignment);
  if (auto& direction = metadata.main_view_direction) {
    direction = Eigen::Vector3d(file_from_model.rotation * *direction);
  }
  return metadata;
}

DrawingFile ReadDrawingJson(const std::string& path) {
  return ParseDrawingJson(path, ReadWholeFile(path, kMaxDrawingBytes));
}

std::string RefinedCamerasOfDrawing(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return "";
  if (std::filesystem::is_directory(path, ignored)) return "";  // of LIMAP
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
