// SPDX-License-Identifier: BSD-3-Clause
#include "limn/viewer/payload.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <variant>

#include <nlohmann/json.hpp>

#include "limn/files/json_text.h"
#include "limn/formats/colors.h"
#include "limn/geometry/median_point.h"
#include "limn/geometry/polyline.h"
#include "limn/model/drawing_paths.h"
#include "limn/util/errors.h"
#include "limn/viewer/payload_arrays.h"

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kTextAlignment = 8;
// Positions of the cloud are rounded to this part of the drawing's size: low bits of noise would
// make most of the page.
constexpr double kCloudSteps = 1 << 15;

// Appends values in order; positions become relative to a center.
struct Values {
  std::vector<float> numbers;

  void Put(const Eigen::Vector3d& vector) {
    for (const double value : vector) numbers.push_back(static_cast<float>(value));
  }
};

// The middle of the drawing by the medians of its coordinates: stray links do not move it.
Eigen::Vector3d CenterOf(const ViewerScene& scene) {
  std::vector<Eigen::Vector3d> points;
  for (const DrawingLink& link : scene.graph.links) {
    points.insert(points.end(), link.points_in_world.begin(), link.points_in_world.end());
  }
  if (points.empty()) {
    for (const View& view : scene.views) points.push_back(view.CenterInWorld());
  }
  return MedianPoint(points);
}

// A power of two: what is rounded to it ends in zero bits.
double CloudStep(const ViewerScene& scene, const Eigen::Vector3d& center) {
  double extent = 0;
  for (const DrawingLink& link : scene.graph.links) {
    for (const Eigen::Vector3d& point : link.points_in_world) {
      extent = std::max(extent, (point - center).cwiseAbs().maxCoeff());
    }
  }
  return extent > 0 ? std::exp2(std::floor(std::log2(extent / kCloudSteps))) : 0;
}

void AddLinkCurves(const ViewerScene& scene, const Eigen::Vector3d& center, PayloadArrays* arrays) {
  Values points;
  std::vector<float> sigmas;
  std::vector<uint32_t> start = {0};
  std::vector<double> length;
  std::vector<float> residual;
  std::vector<int32_t> nodes;
  std::vector<uint8_t> color;
  const std::vector<LinkId> curves = CurvesOf(scene.graph);
  for (size_t id = 0; id < scene.graph.links.size(); ++id) {
    const DrawingLink& link = scene.graph.links[id];
    for (const Eigen::Vector3d& point : link.points_in_world) points.Put(point - center);
    for (const double sigma : link.sigma) sigmas.push_back(static_cast<float>(sigma));
    start.push_back(static_cast<uint32_t>(points.numbers.size() / 3));
    sigmas.resize(start.back(), std::numeric_limits<float>::infinity());
    length.push_back(Length(link.points_in_world));
    residual.push_back(static_cast<float>(link.residual_px));
    nodes.insert(nodes.end(), {link.node0, link.node1});
    const Color of_curve = ColorOfCurve(curves[id]);
    color.insert(color.end(), {of_curve.red, of_curve.green, of_curve.blue});
  }
  arrays->Add("points", points.numbers);
  arrays->Add("sigma", sigmas);
  arrays->Add("linkStart", start);
  arrays->Add("linkLength", length);
  arrays->Add("linkResidual", residual);
  arrays->Add("linkNodes", nodes);
  arrays->Add("linkColor", color);
}

void AddSupport(const ViewerScene& scene, PayloadArrays* arrays) {
  std::vector<uint32_t> start = {0};
  std::vector<uint32_t> views;
  for (size_t id = 0; id < scene.graph.links.size(); ++id) {
    for (const ViewId view : scene.graph.links[id].supporting_views) {
      if (view < 0 || view >= static_cast<ViewId>(scene.views.size())) {
        throw InputError("link " + std::to_string(id) + ": there is no supporting view " +
                         std::to_string(view));
      }
      views.push_back(static_cast<uint32_t>(view));
    }
    start.push_back(static_cast<uint32_t>(views.size()));
  }
  arrays->Add("linkViewStart", start);
  arrays->Add("linkViews", views);
}

// 0 = none, then in the order of CurveShape, with circles behind it (page/src/drawing.js).
uint8_t PrimitiveType(const CurveShape& shape) {
  const auto* arc = std::get_if<CircularArc>(&shape);
  if (arc && arc->IsCircle()) return 4;
  return static_cast<uint8_t>(1 + shape.index());
}

void AddPrimitives(const ViewerScene& scene, PayloadArrays* arrays) {
  std::vector<uint8_t> type;
  std::vector<double> radius, sweep;
  std::vector<float> rms, max;
  std::vector<uint32_t> controls;
  for (const DrawingLink& link : scene.graph.links) {
    const CurveShape* shape = link.primitive ? &link.primitive->shape : nullptr;
    const auto* arc = shape ? std::get_if<CircularArc>(shape) : nullptr;
    const auto* spline = shape ? std::get_if<CubicBSpline>(shape) : nullptr;
    type.push_back(shape ? PrimitiveType(*shape) : 0);
    radius.push_back(arc ? arc->radius : 0);
    sweep.push_back(arc ? arc->sweep_rad : 0);
    controls.push_back(spline ? static_cast<uint32_t>(spline->control_points.size()) : 0);
    rms.push_back(link.primitive ? static_cast<float>(link.primitive->rms_px) : 0);
    max.push_back(link.primitive ? static_cast<float>(link.primitive->max_px) : 0);
  }
  arrays->Add("primitiveType", type);
  arrays->Add("primitiveRadius", radius);
  arrays->Add("primitiveSweep", sweep);
  arrays->Add("primitiveControls", controls);
  arrays->Add("primitiveRms", rms);
  arrays->Add("primitiveMax", max);
}

// Only of drawings that drawing_fuser has made.
void AddDense(const ViewerScene& scene, PayloadArrays* arrays) {
  const auto& links = scene.graph.links;
  const auto has_dense = [](const DrawingLink& link) { return link.dense.has_value(); };
  if (std::none_of(links.begin(), links.end(), has_dense)) return;
  std::vector<uint8_t> dense_class, behind;
  std::vector<float> added, fold;
  for (const DrawingLink& link : links) {
    const LinkDense dense = link.dense.value_or(LinkDense());
    dense_class.push_back(static_cast<uint8_t>(dense.dense_class));
    behind.push_back(dense.behind_surface);
    added.push_back(static_cast<float>(dense.added_share));
    fold.push_back(static_cast<float>(dense.fold_deg));
  }
  arrays->Add("denseClass", dense_class);
  arrays->Add("denseBehind", behind);
  arrays->Add("denseAdded", added);
  arrays->Add("denseFold", fold);
}

void AddKinds(const ViewerScene& scene, PayloadArrays* arrays) {
  std::vector<uint8_t> kind, tentative;
  std::vector<float> kind_confidence, confidence, curve_px;
  std::vector<double> rod_radius, body_radius, body_radius_sigma;
  std::vector<uint8_t> body_shape;  // 0: none
  for (const DrawingLink& link : scene.graph.links) {
    kind.push_back(static_cast<uint8_t>(link.kind));
    kind_confidence.push_back(static_cast<float>(link.kind_confidence));
    confidence.push_back(static_cast<float>(link.confidence));
    curve_px.push_back(static_cast<float>(link.curve_px));
    tentative.push_back(link.tentative);
    rod_radius.push_back(link.rod_radius);
    body_shape.push_back(link.body ? 1 + static_cast<uint8_t>(link.body->shape) : 0);
    body_radius.push_back(link.body ? link.body->MeanRadius() : 0);
    body_radius_sigma.push_back(link.body ? link.body->radius_sigma : 0);
  }
  arrays->Add("linkKind", kind);
  arrays->Add("kindConfidence", kind_confidence);
  arrays->Add("linkConfidence", confidence);
  arrays->Add("linkCurvePx", curve_px);
  arrays->Add("linkTentative", tentative);
  arrays->Add("rodRadius", rod_radius);
  arrays->Add("bodyShape", body_shape);
  arrays->Add("bodyRadius", body_radius);
  arrays->Add("bodyRadiusSigma", body_radius_sigma);
}

void AddNodes(const ViewerScene& scene, const Eigen::Vector3d& center, PayloadArrays* arrays) {
  Values positions, covariances;
  std::vector<uint8_t> kind;
  for (const DrawingNode& node : scene.graph.nodes) {
    positions.Put(node.position_in_world - center);
    for (int column = 0; column < 3; ++column) covariances.Put(node.covariance.col(column));
    kind.push_back(static_cast<uint8_t>(node.kind));
  }
  arrays->Add("nodePositions", positions.numbers);
  arrays->Add("nodeCovariances", covariances.numbers);
  arrays->Add("nodeKind", kind);
}

void AddFaces(const ViewerScene& scene, const Eigen::Vector3d& center, PayloadArrays* arrays) {
  Values vertices;
  std::vector<uint32_t> triangles;  // of vertices of all faces
  std::vector<double> areas;
  for (const DrawingFace& face : scene.graph.faces) {
    const auto first = static_cast<uint32_t>(vertices.numbers.size() / 3);
    for (const Eigen::Vector3d& vertex : face.vertices) vertices.Put(vertex - center);
    for (const auto& triangle : face.triangles) {
      for (const int vertex : triangle) triangles.push_back(first + static_cast<uint32_t>(vertex));
    }
    areas.push_back(AreaOf(face));
  }
  arrays->Add("faceVertices", vertices.numbers);
  arrays->Add("faceTriangles", triangles);
  arrays->Add("faceAreas", areas);
}

// Nine numbers each: from, to, shift.
void AddDimensions(const ViewerScene& scene, const Eigen::Vector3d& center, PayloadArrays* arrays) {
  Values values;
  for (const DrawingDimension& dimension : scene.graph.dimensions) {
    values.Put(dimension.from - center);
    values.Put(dimension.to - center);
    values.Put(dimension.shift);
  }
  arrays->Add("dimensions", values.numbers);
}

void AddCloud(const ViewerScene& scene, const Eigen::Vector3d& center, PayloadArrays* arrays) {
  const double step = CloudStep(scene, center);
  Values positions;
  std::vector<uint8_t> colors;
  for (const ViewerPoint& point : scene.cloud) {
    Eigen::Vector3d position = point.position - center;
    if (step > 0) position = step * (position / step).array().round().matrix();
    positions.Put(position);
    colors.insert(colors.end(), point.color.begin(), point.color.end());
  }
  arrays->Add("cloudPositions", positions.numbers);
  arrays->Add("cloudColors", colors);
}

Json ToJson(const Eigen::Vector2d& pixel) { return {pixel.x(), pixel.y()}; }

Json ToJson(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

Json RowsOf(const Eigen::Matrix3d& matrix) {
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) rows.push_back(matrix(row, column));
  }
  return rows;
}

Json ToJson(const Similarity3d& similarity) {
  return {{"scale", similarity.scale},
          {"rotation", RowsOf(similarity.rotation)},
          {"translation", ToJson(similarity.translation)}};
}

Json ToJson(const View& view, const Eigen::Vector3d& center) {
  const PinholeCamera& camera = view.camera;
  return {{"name", view.name},
          {"width", camera.width},
          {"height", camera.height},
          {"fx", camera.fx},
          {"fy", camera.fy},
          {"cx", camera.cx},
          {"cy", camera.cy},
          {"position", ToJson(Eigen::Vector3d(view.CenterInWorld() - center))},
          {"camFromWorld", RowsOf(view.cam_from_world.rotation.toRotationMatrix())},
          {"region", {{"min", ToJson(view.region.min_px)}, {"max", ToJson(view.region.max_px)}}},
          {"thumbnail", nullptr}};
}

Json AddViews(const ViewerScene& scene, const Eigen::Vector3d& center, PayloadArrays* arrays) {
  if (!scene.thumbnails.empty() && scene.thumbnails.size() != scene.views.size()) {
    throw InputError(std::to_string(scene.thumbnails.size()) + " thumbnails of " +
                     std::to_string(scene.views.size()) + " views");
  }
  std::string jpegs;
  Json views = Json::array();
  for (size_t v = 0; v < scene.views.size(); ++v) {
    views.push_back(ToJson(scene.views[v], center));
    if (scene.thumbnails.empty() || scene.thumbnails[v].jpeg.empty()) continue;
    const ViewerThumbnail& thumbnail = scene.thumbnails[v];
    views.back()["thumbnail"] = {{"offset", jpegs.size()},
                                 {"length", thumbnail.jpeg.size()},
                                 {"min", ToJson(thumbnail.min_px)},
                                 {"max", ToJson(thumbnail.max_px)}};
    jpegs += thumbnail.jpeg;
  }
  arrays->AddBytes("thumbnails", jpegs);
  return views;
}

Json ObjectOf(const char* what, const std::string& text) {
  if (text.empty()) return nullptr;
  Json object = ParseJson(std::string(what) + " of the page", text);
  if (!object.is_object()) {
    throw InputError(std::string("the ") + what + " of a page must be a JSON object");
  }
  return object;
}

}  // namespace

std::string EncodePayload(const ViewerScene& scene) {
  const Eigen::Vector3d center = CenterOf(scene);
  PayloadArrays arrays;
  AddLinkCurves(scene, center, &arrays);
  AddSupport(scene, &arrays);
  AddPrimitives(scene, &arrays);
  AddDense(scene, &arrays);
  AddKinds(scene, &arrays);
  AddNodes(scene, center, &arrays);
  AddFaces(scene, center, &arrays);
  AddDimensions(scene, center, &arrays);
  AddCloud(scene, center, &arrays);
  Json header = {{"format", kPageFormat}, {"version", kPageVersion}, {"title", scene.title}};
  header["center"] = ToJson(center);
  header["shownFromModel"] = ToJson(scene.shown_from_model);
  header["unit"] = scene.unit;
  header["scaleSigma"] = scene.scale_sigma;
  header["zIsUp"] = scene.z_is_up;
  header["drawing"] = {{"name", scene.drawing.name}, {"fingerprint", scene.drawing.fingerprint}};
  header["detail"] = DetailName(scene.detail);
  header["views"] = AddViews(scene, center, &arrays);
  header["report"] = ObjectOf("report", scene.report_json);
  header["settings"] = ObjectOf("settings", scene.settings_json);
  header["arrays"] = arrays.header();
  // Names of files need not be UTF-8.
  std::string text = header.dump(-1, ' ', false, Json::error_handler_t::replace);
  while ((sizeof(uint32_t) + text.size()) % kTextAlignment != 0) text += ' ';
  const auto size = static_cast<uint32_t>(text.size());
  std::string payload(reinterpret_cast<const char*>(&size), sizeof(size));
  return payload + text + arrays.bytes();
}

}  // namespace limn
