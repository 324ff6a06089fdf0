// SPDX-License-Identifier: BSD-3-Clause
#include "browser/wire_scene.h"

#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "limn/geometry/polyline.h"
#include "limn/pictures/thumbnail.h"
#include "support/synthetic_scene.h"

namespace limn::testing {
namespace {

using Json = nlohmann::ordered_json;

const Eigen::Vector3d kFarAway(412345.5, 5312345.25, 98.75);
constexpr double kHalfSide = 1;
constexpr double kRadius = 0.55;
constexpr int kSegmentsPerEdge = 8;
constexpr int kSegmentsOfCircle = 96;
constexpr int kNumViews = 6;
constexpr double kPi = 3.14159265358979323846;
// Of nodes along the axes, and of the scale.
const Eigen::Vector3d kNodeSigmas(0.002, 0.003, 0.004);
constexpr double kScaleSigma = 0.001;

DrawingLink MakeLink(std::vector<Eigen::Vector3d> points, NodeId node0, NodeId node1) {
  DrawingLink link;
  link.points_in_world = std::move(points);
  link.node0 = node0;
  link.node1 = node1;
  link.closed = node0 == node1;
  return link;
}

// Numbers that differ from link to link.
void SetFigures(size_t id, DrawingLink* link) {
  link->sigma.assign(link->points_in_world.size(), 0.001 * static_cast<double>(id + 1));
  link->residual_px = 0.1 + 0.05 * static_cast<double>(id);
  for (ViewId view = 0; view < kNumViews; ++view) {
    if (view == static_cast<ViewId>(id % kNumViews)) continue;
    link->supporting_views.push_back(view);
  }
  link->kind = static_cast<LinkKind>(id / 4 % 4);
  link->kind_confidence = link->kind == LinkKind::kUnknown ? 0 : 0.75;
  link->dense = LinkDense{static_cast<DenseClass>(id % 4), 0.25, 0, false, -1};
}

void AddCube(DrawingGraph* graph) {
  const std::vector<Eigen::Vector3d> corners = CubeCorners(kHalfSide);
  for (const Eigen::Vector3d& corner : corners) {
    graph->nodes.emplace_back().position_in_world = kFarAway + corner;
  }
  for (int from = 0; from < 8; ++from) {
    for (const int bit : {1, 2, 4}) {
      if (from & bit) continue;
      const Eigen::Vector3d start = kFarAway + corners[from];
      const Eigen::Vector3d end = kFarAway + corners[from | bit];
      std::vector<Eigen::Vector3d> points;
      for (int i = 0; i <= kSegmentsPerEdge; ++i) {
        points.push_back(i == kSegmentsPerEdge ? end
                                               : start + (end - start) * i / kSegmentsPerEdge);
      }
      graph->links.push_back(MakeLink(points, from, from | bit));
      graph->links.back().primitive = LinkPrimitive{LineSegment{start, end}, 0.125, 0.25};
    }
  }
}

void AddCircle(DrawingGraph* graph) {
  const Eigen::Vector3d center = kFarAway + Eigen::Vector3d(0, 0, kHalfSide);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < kSegmentsOfCircle; ++i) {
    const double angle = 2 * kPi * i / kSegmentsOfCircle;
    points.push_back(center + kRadius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0));
  }
  points.push_back(points.front());
  const auto anchor = static_cast<NodeId>(graph->nodes.size());
  graph->nodes.emplace_back().position_in_world = points.front();
  graph->links.push_back(MakeLink(points, anchor, anchor));
  CircularArc circle;
  circle.center = center;
  circle.radius = kRadius;
  circle.sweep_rad = 2 * kPi;
  graph->links.back().primitive = LinkPrimitive{circle, 0.125, 0.25};
}

Image PlainPhoto(const View& view) {
  Image photo{view.camera.width, view.camera.height, 3, {}, {}};
  for (int i = 0; i < photo.width * photo.height; ++i) {
    photo.data.insert(photo.data.end(), {30.f, 90.f, 200.f});
  }
  return photo;
}

void AddViews(ViewerScene* scene) {
  for (View view : DomeViews(kNumViews, 6)) {
    const auto v = static_cast<double>(scene->views.size());
    view.name = "<b>view</b> & " + std::to_string(scene->views.size()) + ".jpg";
    view.camera.cx += 40 - 10 * v;
    view.camera.cy -= 25 - 8 * v;
    view.camera.fy *= 1.03;
    view.cam_from_world.translation -= view.cam_from_world.rotation * kFarAway;
    const Thumbnail made = MakeThumbnail(PlainPhoto(view), view, {320});
    scene->thumbnails.push_back({made.min_px, made.max_px, made.jpeg});
    scene->views.push_back(view);
  }
}

Json SamplesIn(const View& view, const DrawingLink& link) {
  constexpr double kStepPx = 0.25;
  Json samples = Json::array();
  const auto& points = link.points_in_world;
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    const auto from = view.Project(points[i]);
    const auto to = view.Project(points[i + 1]);
    if (!from || !to) continue;
    const int steps = std::max(1, static_cast<int>(std::ceil((*to - *from).norm() / kStepPx)));
    for (int step = 0; step < steps; ++step) {
      const auto pixel = view.Project(points[i] + (points[i + 1] - points[i]) * step / steps);
      if (pixel) samples.push_back({pixel->x(), pixel->y()});
    }
  }
  return samples;
}

Json ToJson(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

}  // namespace

ViewerScene WireScene() {
  ViewerScene scene;
  scene.title = "wires";
  AddCube(&scene.graph);
  AddCircle(&scene.graph);
  for (size_t id = 0; id < scene.graph.links.size(); ++id) SetFigures(id, &scene.graph.links[id]);
  for (DrawingNode& node : scene.graph.nodes) {
    node.covariance = kNodeSigmas.cwiseAbs2().asDiagonal();
  }
  scene.scale_sigma = kScaleSigma;
  RebuildIncidence(&scene.graph);
  AddViews(&scene);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d offset(std::cos(i), std::sin(2 * i), std::sin(3 * i));
    scene.cloud.push_back({kFarAway + offset, {200, 120, 40}});
  }
  scene.report_json = R"({"title": "A run", "stages": [
      {"stage": "edges", "seconds": 1.5, "peak_mb": 100, "in": {"images": 6},
       "kept": {"edgels": 12345}, "dropped": {"weak": 17}}],
    "warnings": ["<img src=x onerror=alert(1)> is a text"],
    "trust": {"images": 6, "explained": 0.21, "agree_less": [{"name": "<b>.jpg", "share": 0.013}],
              "many_views": 5, "well_seen": 0.75, "error_px": 0.123, "error_90_px": 0.5,
              "tentative": 0.125},
    "options_changed": {"Drawing.min_supporting_views": 4},
    "support_histogram": [0, 0, 0, 0, 0, 13],
    "evaluation": [{"tau": 1, "unit": "footprint", "precision": 0.9, "recall": 0.8, "f": 0.847}],
    "pr_curves": [{"name": "swept", "points": [[0.5, 0.95], [0.8, 0.9]]}]})";
  return scene;
}

Json Expectations(const ViewerScene& scene) {
  Json json = {{"links", Json::array()}, {"nodes", Json::array()}, {"views", Json::array()}};
  json["nodeSigmas"] = ToJson(kNodeSigmas);
  json["scaleSigma"] = kScaleSigma;
  for (const DrawingLink& link : scene.graph.links) {
    json["links"].push_back({{"length", Length(link.points_in_world)},
                             {"residual", link.residual_px},
                             {"sigma", link.sigma.front()},
                             {"class", DenseClassName(link.dense->dense_class)},
                             {"views", link.supporting_views}});
  }
  for (const DrawingNode& node : scene.graph.nodes) {
    json["nodes"].push_back(ToJson(node.position_in_world));
  }
  for (const View& view : scene.views) {
    Json seen = {{"name", view.name},
                 {"width", view.camera.width},
                 {"height", view.camera.height},
                 {"links", Json::array()},
                 {"nodes", Json::array()}};
    for (const DrawingLink& link : scene.graph.links) {
      seen["links"].push_back(SamplesIn(view, link));
    }
    for (const DrawingNode& node : scene.graph.nodes) {
      const auto pixel = view.Project(node.position_in_world);
      seen["nodes"].push_back(pixel ? Json{pixel->x(), pixel->y()} : Json());
    }
    json["views"].push_back(seen);
  }
  return json;
}

ViewerScene LargeScene() {
  constexpr int kNumLinks = 1000, kSegments = 100, kNumPoints = 200000;
  const auto on_torus = [](double around, double across, double thickness) {
    const double out = 3 + thickness * std::cos(across);
    return Eigen::Vector3d(out * std::cos(around), out * std::sin(around),
                           thickness * std::sin(across));
  };
  ViewerScene scene;
  scene.title = "large";
  for (int link = 0; link < kNumLinks; ++link) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i <= kSegments; ++i) {
      const double across = 2 * kPi * i / (kSegments + 20);
      points.push_back(on_torus(2 * kPi * link / kNumLinks + 0.1 * across, across, 1));
    }
    for (const auto& end : {points.front(), points.back()}) {
      scene.graph.nodes.emplace_back().position_in_world = end;
    }
    scene.graph.links.push_back(MakeLink(points, 2 * link, 2 * link + 1));
    scene.graph.links.back().sigma.assign(points.size(), 0.01);
  }
  RebuildIncidence(&scene.graph);
  for (int i = 0; i < kNumPoints; ++i) {
    const auto gray = static_cast<uint8_t>(60 + i % 150);
    scene.cloud.push_back({on_torus(0.37 * i, 1.13 * i, 0.9), {gray, gray, gray}});
  }
  scene.views = DomeViews(24, 9);
  return scene;
}

}  // namespace limn::testing
