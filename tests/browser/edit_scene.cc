// SPDX-License-Identifier: BSD-3-Clause
#include "browser/edit_scene.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "limn/model/drawing_transform.h"

namespace limn::testing {
namespace {

using Json = nlohmann::ordered_json;
using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;
constexpr int kSegments = 8;

Similarity3d ShownFromModel() {
  const Eigen::AngleAxisd turn(0.7, Vector3d(1, 2, 3).normalized());
  return {2.5, turn.toRotationMatrix(), Vector3d(400, -300, 20)};
}

// Builds a graph in which links may share nodes.
struct Builder {
  DrawingGraph graph;

  NodeId Node(const Vector3d& position) {
    graph.nodes.emplace_back().position_in_world = position;
    return static_cast<NodeId>(graph.nodes.size()) - 1;
  }

  LinkId Straight(NodeId from, NodeId to) {
    const Vector3d start = graph.nodes[from].position_in_world;
    const Vector3d end = graph.nodes[to].position_in_world;
    DrawingLink link;
    for (int i = 0; i < kSegments; ++i) {
      link.points_in_world.push_back(start + (end - start) * i / kSegments);
    }
    link.points_in_world.push_back(end);
    return Add(std::move(link), from, to);
  }

  LinkId Straight(const Vector3d& start, const Vector3d& end) {
    return Straight(Node(start), Node(end));
  }

  LinkId Circle(const Vector3d& center, double radius) {
    constexpr int kCorners = 48;
    DrawingLink link;
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2 * kPi * i / kCorners;
      link.points_in_world.push_back(center +
                                     radius * Vector3d(std::cos(angle), std::sin(angle), 0));
    }
    link.points_in_world.push_back(link.points_in_world.front());
    const NodeId anchor = Node(link.points_in_world.front());
    link.closed = true;
    return Add(std::move(link), anchor, anchor);
  }

  LinkId Add(DrawingLink link, NodeId from, NodeId to) {
    link.node0 = from;
    link.node1 = to;
    link.sigma.assign(link.points_in_world.size(), 0.01);
    link.supporting_views = {0};
    link.kind = LinkKind::kEdge;
    link.kind_confidence = 0.75;
    graph.links.push_back(std::move(link));
    return static_cast<LinkId>(graph.links.size()) - 1;
  }
};

DrawingFace SquareFace() {
  DrawingFace face;
  face.vertices = {{1, -3, 0}, {3, -3, 0}, {3, -1, 0}, {1, -1, 0}};
  face.triangles = {{0, 1, 2}, {0, 2, 3}};
  FaceLoop border;
  for (size_t i = 0; i < 4; ++i) {
    border.push_back({-1, 0, 0, {face.vertices[i], face.vertices[(i + 1) % 4]}});
  }
  face.loops = {border};
  return face;
}

DrawingGraph LinksToEdit() {
  Builder builder;
  builder.Straight({0, 0, 0}, {4, 0, 0});
  builder.Straight({4.5, 0, 0}, {8, 0, 0});
  builder.Straight({0, 2, 0}, {8, 2, 0});
  builder.Straight({1, 2.25, 0}, {6, 2.25, 0});
  const NodeId corner = builder.Node({3, 4, 0});
  for (const Vector3d& end : {Vector3d(0, 4, 0), Vector3d(3, 5.5, 0), Vector3d(5.5, 4, 0)}) {
    builder.Straight(builder.Node(end), corner);
  }
  builder.graph.links[builder.Straight({0, 6, 0}, {2, 6, 0})].tentative = true;
  builder.graph.links[builder.Straight({5, 6, 0}, {7, 6, 0})].kind = LinkKind::kContour;
  builder.Circle({7, 4, 0}, 0.7);
  builder.Straight({3.8, 6, 0}, {4.1, 6, 0});
  builder.Straight({1.5, -2, -1}, {2.5, -2, -1});
  builder.Straight({1, -3, 0}, {3, -3, 0});
  builder.graph.faces = {SquareFace()};
  builder.graph.dimensions = {{{0, 0, 0}, {4, 0, 0}, {0, -0.5, 0}}};
  RebuildIncidence(&builder.graph);
  return builder.graph;
}

View FromAbove() {
  View view;
  view.name = "above.jpg";
  view.camera = {560, 560, 400, 300, 800, 600};
  view.cam_from_world.rotation = Eigen::Quaterniond(0, 1, 0, 0);  // half a turn about x
  view.cam_from_world.translation = -(view.cam_from_world.rotation * Vector3d(4, 1.5, 10));
  return view;
}

Json ToJson(const Vector3d& point) { return {point.x(), point.y(), point.z()}; }

Json ToJson(const std::vector<Vector3d>& points) {
  Json json = Json::array();
  for (const Vector3d& point : points) json.push_back(ToJson(point));
  return json;
}

}  // namespace

ViewerScene EditScene() {
  const Similarity3d shown_from_model = ShownFromModel();
  ViewerScene scene;
  scene.title = "to edit";
  scene.unit = "m";
  scene.shown_from_model = shown_from_model;
  scene.graph = Transformed(LinksToEdit(), shown_from_model.scale, shown_from_model.rotation,
                            shown_from_model.translation);
  scene.views = {FromAbove()};
  scene.views[0].cam_from_world = CamFromB(scene.views[0].cam_from_world, shown_from_model);
  return scene;
}

Json EditExpectations(const ViewerScene& scene) {
  Json json = {{"scale", scene.shown_from_model.scale},
               {"links", Json::array()},
               {"faces", ToJson(scene.graph.faces[0].vertices)}};
  const DrawingGraph in_model = LinksToEdit();
  for (size_t id = 0; id < in_model.links.size(); ++id) {
    json["links"].push_back({{"shown", ToJson(scene.graph.links[id].points_in_world)},
                             {"model", ToJson(in_model.links[id].points_in_world)}});
  }
  return json;
}

ViewerScene ManyLinksScene() {
  constexpr int kNumLinks = 4000, kSegmentsEach = 100;
  ViewerScene scene;
  scene.title = "many links";
  for (int i = 0; i < kNumLinks; ++i) {
    DrawingLink link;
    const Vector3d start(i % 63, i / 63 % 63, 0.3 * std::sin(i));
    for (int k = 0; k <= kSegmentsEach; ++k) {
      const double t = static_cast<double>(k) / kSegmentsEach;
      link.points_in_world.push_back(start +
                                     Vector3d(t, 0.6 * std::sin(5 * t + i), 0.5 * std::cos(i * t)));
    }
    const auto node = static_cast<NodeId>(scene.graph.nodes.size());
    scene.graph.nodes.emplace_back().position_in_world = link.points_in_world.front();
    scene.graph.nodes.emplace_back().position_in_world = link.points_in_world.back();
    link.node0 = node;
    link.node1 = node + 1;
    link.sigma.assign(link.points_in_world.size(), 0.01);
    scene.graph.links.push_back(std::move(link));
  }
  RebuildIncidence(&scene.graph);
  return scene;
}

}  // namespace limn::testing
