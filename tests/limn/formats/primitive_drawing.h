// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "limn/model/drawing_graph.h"

namespace limn {

// A drawing with links of all kinds, in tilted planes:
//   0 line and 1 arc, which continues it, and 2 spline, which meets the arc at a corner
//   3 line and 4 polyline, at the junction of 0 and 1
//   5 arc and 6 polyline, parallel, on their own
//   7 circle, 8 closed polyline, 9 closed spline, each on its own
//   10 arc of more than half a turn, and 11 arc in a plane that is nearly level, on their own
class PrimitiveDrawingBuilder {
 public:
  NodeId AddNode(const Eigen::Vector3d& position) {
    DrawingNode node;
    node.position_in_world = position;
    graph_.nodes.push_back(node);
    return static_cast<NodeId>(graph_.nodes.size()) - 1;
  }

  // Nodes that are not given are made; a circle or closed spline has one.
  LinkId AddShape(const CurveShape& shape, NodeId node0 = -1, NodeId node1 = -1) {
    std::vector<Eigen::Vector3d> points = SampleShape(shape, 1e-4);
    const bool closed = (points.front() - points.back()).norm() < 1e-12;
    if (node0 < 0) node0 = AddNode(points.front());
    if (closed) node1 = node0;
    if (node1 < 0) node1 = AddNode(points.back());
    const LinkId id = AddPolyline(std::move(points), node0, node1);
    LinkPrimitive& primitive = graph_.links[id].primitive.emplace();
    primitive.shape = shape;
    primitive.rms_px = 0.25;
    primitive.max_px = 0.5;
    return id;
  }

  // The ends are moved to the nodes.
  LinkId AddPolyline(std::vector<Eigen::Vector3d> points, NodeId node0, NodeId node1) {
    DrawingLink link;
    points.front() = graph_.nodes[node0].position_in_world;
    points.back() = graph_.nodes[node1].position_in_world;
    link.sigma.assign(points.size(), 0.125);
    link.points_in_world = std::move(points);
    link.node0 = node0;
    link.node1 = node1;
    link.closed = node0 == node1;
    link.supporting_views = {0, 1};
    link.residual_px = 0.1;
    graph_.links.push_back(link);
    return static_cast<LinkId>(graph_.links.size()) - 1;
  }

  DrawingGraph& graph() { return graph_; }

 private:
  DrawingGraph graph_;
};

// An arc of radius r about c, in a plane turned by `turn` about a skew axis, from an angle on.
inline CircularArc TiltedArc(const Eigen::Vector3d& center, double radius, double turn,
                             double start_rad, double sweep_rad) {
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(turn, Eigen::Vector3d(0.3, -1, 0.4).normalized()).toRotationMatrix();
  CircularArc arc;
  arc.center = center;
  arc.x_axis = rotation * Eigen::Vector3d(std::cos(start_rad), std::sin(start_rad), 0);
  arc.y_axis = rotation * Eigen::Vector3d(-std::sin(start_rad), std::cos(start_rad), 0);
  arc.radius = radius;
  arc.sweep_rad = sweep_rad;
  return arc;
}

inline DrawingGraph PrimitiveDrawing() {
  PrimitiveDrawingBuilder builder;
  const DrawingGraph& graph = builder.graph();
  const CircularArc arc = TiltedArc({1, 2, 3}, 0.75, 0.9, 0.4, 1.3);
  const Eigen::Vector3d corner = PointAt(arc, 0), arc_end = PointAt(arc, 1);
  // Against the arc's direction, so that it continues the line.
  const Eigen::Vector3d line_start = corner - 2 * DerivativeAt(arc, 0).normalized();
  builder.AddShape(LineSegment{line_start, corner});
  const NodeId junction = graph.links[0].node1;
  builder.AddShape(arc, junction);
  builder.AddShape(
      CubicBSpline{
          {0, 0, 0, 0, 0.4, 1, 1, 1, 1},
          {arc_end, arc_end + Eigen::Vector3d(1, 0, 0.2), arc_end + Eigen::Vector3d(1.2, 1, -0.5),
           arc_end + Eigen::Vector3d(2, 1, 0.1), arc_end + Eigen::Vector3d(2.5, 0.3, 0.9)}},
      graph.links[1].node1);
  builder.AddShape(LineSegment{corner, corner + Eigen::Vector3d(0.1, 0.2, 1.5)}, junction);
  const NodeId end = builder.AddNode(corner + Eigen::Vector3d(-1, 0, 0.5));
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  builder.AddPolyline({zero, corner + Eigen::Vector3d(-0.3, 0.2, 0.1),
                       corner + Eigen::Vector3d(-0.7, 0.1, 0.4), zero},
                      junction, end);

  builder.AddShape(TiltedArc({10, 0, 0}, 1, -1.4, -1, 0.7));
  builder.AddPolyline({zero, {10, 1, 2}, zero}, graph.links[5].node0, graph.links[5].node1);
  builder.AddShape(TiltedArc({20, 0, 1}, 2, 2.5, 0.3, 2 * M_PI));
  const NodeId anchor = builder.AddNode({30, 0, 0});
  builder.AddPolyline({zero, {31, 0, 0}, {31, 1, 0.5}, {30, 1, 0}, zero}, anchor, anchor);
  builder.AddShape(
      CubicBSpline{{0, 0, 0, 0, 1, 2, 3, 3, 3, 3},
                   {{40, 0, 0}, {41, 0, 0}, {42, 2, 1}, {40, 3, 0}, {38, 1, 0.5}, {40, 0, 0}}});
  builder.AddShape(TiltedArc({50, -3, 2}, 1.5, 3.0, 2, 5.5));
  // The z axis of the plane is within 1/64 of the world's.
  builder.AddShape(TiltedArc({60, 5, -2}, 1.25, 0.005, -2, 3));

  RebuildIncidence(&builder.graph());
  builder.graph().nodes[junction].continuations = {{{0, 1}, {1, 0}}};
  builder.graph().links[3].dense = LinkDense{DenseClass::kBoundary, 0.5, 0, false, -1};
  builder.graph().links[4].dense = LinkDense{DenseClass::kSurface, 0.5, 0, false, -1};
  return builder.graph();
}

}  // namespace limn
