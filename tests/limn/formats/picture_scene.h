// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "limn/geometry/polyline.h"
#include "limn/geometry/triangle_mesh.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// A drawing with one link of each shape, two of them without one, all within 2 units of the origin
// and z up; links 0, 1 and 2 meet at a junction.
//   0 line, 1 line, 2 line, 3 circle (tilted), 4 arc of three quarters, 5 spline,
//   6 helix without shape, 7 zigzag without shape, 8 line that the wall hides in part
inline CubicBSpline SceneSpline() {
  return {{0, 0, 0, 0, 0.3, 0.6, 1, 1, 1, 1},
          {{-1.6, -1.2, 0.1},
           {-1.2, 0.1, 0.4},
           {-1.5, 0.7, 0.9},
           {-0.6, 1.5, 0.2},
           {0.2, 1.0, 0.8},
           {0.9, 1.6, 1.1}}};
}

inline std::vector<CurveShape> SceneShapes() {
  const Eigen::Vector3d tilted = Eigen::Vector3d(0.6, 0, 0.8);
  return {LineSegment{{0, 0, 0}, {1.2, 0.1, 0.2}},
          LineSegment{{0, 0, 0}, {-0.2, 0.9, 0.1}},
          LineSegment{{0, 0, 0}, {0.1, -0.1, 1.3}},
          CircularArc{{0.9, -0.8, 0.5}, tilted, Eigen::Vector3d::UnitY(), 0.5, 2 * M_PI},
          CircularArc{{-0.7, -0.7, 0.2},
                      Eigen::Vector3d::UnitX(),
                      Eigen::Vector3d(0, 0.8, 0.6),
                      0.4,
                      1.5 * M_PI},
          SceneSpline()};
}

inline std::vector<Eigen::Vector3d> Helix() {
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k <= 150; ++k) {
    const double angle = 0.1 * k;
    points.emplace_back(0.9 + 0.3 * std::cos(angle), 0.8 + 0.3 * std::sin(angle), 0.08 * angle);
  }
  return points;
}

inline int AddNode(const Eigen::Vector3d& position, DrawingGraph* graph) {
  for (size_t id = 0; id < graph->nodes.size(); ++id) {
    if (graph->nodes[id].position_in_world == position) return static_cast<int>(id);
  }
  graph->nodes.emplace_back().position_in_world = position;
  return static_cast<int>(graph->nodes.size()) - 1;
}

inline void AddLink(std::vector<Eigen::Vector3d> points, std::optional<CurveShape> shape,
                    DrawingGraph* graph) {
  DrawingLink link;
  link.closed = points.front() == points.back();
  link.node0 = AddNode(points.front(), graph);
  link.node1 = AddNode(points.back(), graph);
  link.sigma.assign(points.size(), 0.001);
  link.points_in_world = std::move(points);
  if (shape) link.primitive = LinkPrimitive{*shape, 0.1, 0.3};
  graph->links.push_back(link);
}

inline DrawingGraph PictureScene() {
  DrawingGraph graph;
  for (const CurveShape& shape : SceneShapes()) {
    AddLink(SampleShape(shape, 1e-4), shape, &graph);
  }
  AddLink(Helix(), std::nullopt, &graph);
  AddLink({{-1.5, -1.5, 0}, {-1.0, -1.4, 0.3}, {-0.9, -1.6, 0.1}, {-0.2, -1.5, 0.4}}, std::nullopt,
          &graph);
  const LineSegment behind = {{-0.5, 1.9, 1.2}, {1.5, 1.9, 1.25}};
  AddLink({behind.start, behind.end}, behind, &graph);
  RebuildIncidence(&graph);
  return graph;
}

// Upright, in front of the middle of link 8 as seen by SceneView and from the front right.
constexpr double kWallY = 1.7;
inline TriangleMesh SceneWall() {
  return MakeTriangleMesh(
      {{0.2, kWallY, 0.8}, {0.9, kWallY, 0.8}, {0.9, kWallY, 1.7}, {0.2, kWallY, 1.7}},
      {{0, 1, 2, 3}});
}

// Whether the wall stands between an eye and a point.
inline bool WallHides(const Eigen::Vector3d& eye, const Eigen::Vector3d& point, double grow) {
  if ((eye.y() - kWallY) * (point.y() - kWallY) >= 0) return false;
  const double t = (kWallY - eye.y()) / (point.y() - eye.y());
  const Eigen::Vector3d at = eye + t * (point - eye);
  return at.x() > 0.2 - grow && at.x() < 0.9 + grow && at.z() > 0.8 - grow && at.z() < 1.7 + grow;
}

// Radial distortion about the middle of the image: stored = c + (virtual - c) (1 + k r^2).
class RadialLens : public LensMap {
 public:
  RadialLens(const Eigen::Vector2d& center, double focal, double k)
      : center_(center), focal_(focal), k_(k) {}
  std::optional<Eigen::Vector2d> StoredFromVirtual(const Eigen::Vector2d& pixel) const override {
    const Eigen::Vector2d away = pixel - center_;
    return Eigen::Vector2d(center_ + (1 + k_ * away.squaredNorm() / (focal_ * focal_)) * away);
  }
  std::optional<Eigen::Vector2d> VirtualFromStored(const Eigen::Vector2d& stored) const override {
    Eigen::Vector2d pixel = stored;
    for (int i = 0; i < 50; ++i) {
      const double squared = (pixel - center_).squaredNorm();
      pixel = center_ + (stored - center_) / (1 + k_ * squared / (focal_ * focal_));
    }
    return pixel;
  }

 private:
  Eigen::Vector2d center_;
  double focal_;
  double k_;
};

// From the front right and above; a strong lens.
inline View SceneView() {
  View view;
  view.name = "scene.png";
  view.camera = {500, 500, 319.5, 239.5, 640, 480};
  const Eigen::Vector3d eye(1.5, -4.5, 3.0);
  const Eigen::Vector3d forward = (Eigen::Vector3d(0, 0, 0.4) - eye).normalized();
  Eigen::Matrix3d axes;
  axes.row(2) = forward;
  axes.row(0) = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  axes.row(1) = axes.row(2).cross(axes.row(0));
  view.cam_from_world.rotation = axes;
  view.cam_from_world.translation = -(axes * eye);
  view.lens = std::make_shared<RadialLens>(Eigen::Vector2d(319.5, 239.5), 500, -0.25);
  view.region = MakeImageRegion(view.camera, view.lens.get(), {}, 0);
  return view;
}

}  // namespace limn
