// SPDX-License-Identifier: BSD-3-Clause
#include "limn/regularity/apply_shapes.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "limn/geometry/polyline.h"
#include "limn/primitives/shape_fit.h"

namespace limn {
namespace {

using Eigen::Vector3d;

// Ends that move by less have not moved, px.
constexpr double kMovedPx = 1e-3;

// A shape whose ends move. An arc stays similar; a spline is linear in its control points.
CurveShape WithMovedEnds(const CurveShape& shape, const Vector3d& at_start,
                         const Vector3d& at_end) {
  if (const auto* line = std::get_if<LineSegment>(&shape)) {
    return LineSegment{line->start + at_start, line->end + at_end};
  }
  if (std::holds_alternative<CircularArc>(shape)) {
    const Vector3d start = PointAt(shape, 0);
    const Vector3d chord = PointAt(shape, 1) - start;
    const Vector3d new_chord = chord + at_end - at_start;
    const double scale = new_chord.norm() / chord.norm();
    if (!(scale > 0.5 && scale < 2)) {  // nearly a circle
      return Transformed(shape, 1, Eigen::Matrix3d::Identity(), at_start);
    }
    const Eigen::Matrix3d turn =
        Eigen::Quaterniond::FromTwoVectors(chord, new_chord).toRotationMatrix();
    return Transformed(shape, scale, turn, start + at_start - scale * turn * start);
  }
  CubicBSpline spline = std::get<CubicBSpline>(shape);
  for (size_t k = 0; k < spline.control_points.size(); ++k) {
    const double t = (spline.knots[k + 1] + spline.knots[k + 2] + spline.knots[k + 3]) / 3;
    spline.control_points[k] += (1 - t) * at_start + t * at_end;
  }
  return spline;
}

// The moves of the ends, blended along the link.
void MovePoints(const Vector3d& at_start, const Vector3d& at_end, Polyline3d* points) {
  const double length = Length(*points);
  double along = 0;
  Vector3d before = points->front();
  for (Vector3d& point : *points) {
    along += (point - before).norm();
    before = point;
    const double t = along / length;
    point += (1 - t) * at_start + t * at_end;
  }
}

// Where the shapes put the nodes. Lines come last, as they end exactly at their nodes.
std::vector<std::optional<Vector3d>> PlacesOfNodes(const NewShapes& shapes,
                                                   const DrawingGraph& graph) {
  std::vector<std::optional<Vector3d>> places(graph.nodes.size());
  for (const bool lines : {false, true}) {
    for (size_t l = 0; l < shapes.size(); ++l) {
      if (!shapes[l] || std::holds_alternative<LineSegment>(*shapes[l]) != lines) continue;
      const DrawingLink& link = graph.links[l];
      for (const int end : {0, 1}) {
        const DrawingNode& node = graph.nodes[link.NodeAt(end)];
        Vector3d place = PointAt(*shapes[l], end);
        // A free end of a shape may be beside its node.
        if (node.Degree() < 2) {
          place += node.position_in_world - PointAt(link.primitive->shape, end);
        }
        places[link.NodeAt(end)] = place;
      }
    }
  }
  return places;
}

}  // namespace

void ApplyShapes(const NewShapes& shapes, const std::vector<LinkSamples>& samples,
                 DrawingGraph* graph) {
  const std::vector<std::optional<Vector3d>> places = PlacesOfNodes(shapes, *graph);
  std::vector<uint8_t> changed(graph->links.size(), 0);
  for (size_t l = 0; l < graph->links.size(); ++l) {
    DrawingLink& link = graph->links[l];
    if (!shapes[l] && !places[link.node0] && !places[link.node1]) continue;
    Vector3d moves[2] = {Vector3d::Zero(), Vector3d::Zero()};
    for (const int end : {0, 1}) {
      const NodeId node = link.NodeAt(end);
      if (places[node]) moves[end] = *places[node] - graph->nodes[node].position_in_world;
    }
    const Polyline3d before = link.points_in_world;
    MovePoints(moves[0], moves[1], &link.points_in_world);
    if (places[link.node0]) link.points_in_world.front() = *places[link.node0];
    if (places[link.node1]) link.points_in_world.back() = *places[link.node1];
    changed[l] = link.points_in_world != before;
    if (!link.primitive) continue;
    CurveShape& shape = link.primitive->shape;
    shape = shapes[l] ? *shapes[l] : WithMovedEnds(shape, moves[0], moves[1]);
    if (samples[l].samples.empty()) continue;
    const ShapeResidual residual = ResidualOf(shape, samples[l]);
    link.primitive->rms_px = residual.RmsPx();
    link.primitive->max_px = residual.max_px;
  }
  for (size_t n = 0; n < places.size(); ++n) {
    if (places[n]) graph->nodes[n].position_in_world = *places[n];
  }
  DropFacesOf(changed, graph);
}

std::vector<double> MovesPx(const DrawingGraph& before, const NewShapes& shapes,
                            const std::vector<LinkSamples>& samples) {
  std::vector<double> moves;
  for (size_t l = 0; l < shapes.size(); ++l) {
    if (!shapes[l]) continue;
    for (const int end : {0, 1}) {
      const LinkSample3d& at = end == 0 ? samples[l].samples.front() : samples[l].samples.back();
      const Vector3d move =
          PointAt(*shapes[l], end) - PointAt(before.links[l].primitive->shape, end);
      const double px = (at.across * move).norm();
      if (px > kMovedPx) moves.push_back(px);
    }
  }
  return moves;
}

}  // namespace limn
