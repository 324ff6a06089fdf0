// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/small_model.h"

#include <string>

namespace limn::colmap_ext {

SparseModel MakeScene() {
  SparseModel model;
  Camera camera;
  camera.id = 1;
  camera.model = CameraModelId::kSimplePinhole;
  camera.width = 200;
  camera.height = 100;
  camera.params = {100, 100, 50};
  model.cameras = {camera};
  for (const int i : {2, 1, 3}) {
    ModelImage image;
    image.id = static_cast<uint32_t>(10 * i);
    image.camera_id = 1;
    image.name = std::string(1, static_cast<char>('a' + i)) + ".png";
    image.cam_from_world.translation = {1 - 0.5 * i, 0, 4};
    image.observations.resize(i);
    model.images.push_back(image);
  }
  model.points = {{41, {0, 0, 0}, {}, -1, {}}};
  return model;
}

std::vector<View> ViewsOf(const SparseModel& model) {
  std::vector<View> views;
  for (size_t i = 0; i < model.images.size(); ++i) {
    View view;
    view.model_index = static_cast<int>(i);
    view.name = model.images[i].name;
    view.camera = {50, 50, 49.5, 24.5, 100, 50};
    view.cam_from_world = model.images[i].cam_from_world;
    view.region = MakeImageRegion(view.camera, nullptr, {}, 0);
    views.push_back(view);
  }
  return views;
}

DrawingFile MakeDrawing() {
  DrawingFile drawing;
  drawing.metadata.view_names = {"b.png", "c.png", "d.png"};
  drawing.graph.nodes.resize(3);
  drawing.graph.nodes[0].position_in_world = {-1, 0, 0};
  drawing.graph.nodes[1].position_in_world = {0.5, 0.25, 0};
  drawing.graph.nodes[2].position_in_world = {0.75, -0.5, 0};
  const auto add = [&](NodeId node0, NodeId node1, const std::vector<Eigen::Vector3d>& inner) {
    DrawingLink link;
    link.points_in_world = {drawing.graph.nodes[node0].position_in_world};
    link.points_in_world.insert(link.points_in_world.end(), inner.begin(), inner.end());
    link.points_in_world.push_back(drawing.graph.nodes[node1].position_in_world);
    link.sigma.assign(link.points_in_world.size(), 0.25);
    link.node0 = node0;
    link.node1 = node1;
    link.supporting_views = {0, 2};
    drawing.graph.links.push_back(link);
  };
  add(0, 1, {});
  add(1, 2, {{0.85, 0, 0}, {0.9, -0.25, 0}});
  RebuildIncidence(&drawing.graph);
  return drawing;
}

}  // namespace limn::colmap_ext
