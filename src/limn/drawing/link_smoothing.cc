// SPDX-License-Identifier: BSD-3-Clause
#include "limn/drawing/link_smoothing.h"

#include "limn/drawing/curve_smoothing.h"
#include "limn/topology/graph_editor.h"
#include "limn/topology/link_geometry.h"

namespace limn {
namespace {

void Smooth(double bending_sigma_px, DrawingLink* link) {
  SampleArrays curve;
  curve.position = link->points_in_world;
  if (link->closed) curve.position.pop_back();  // the repeated first point
  for (int k = 0; k < curve.NumSamples(); ++k) {
    const Eigen::Vector3d direction = DirectionAt(curve.position, link->closed, k, 1);
    curve.tangent.push_back(direction.isZero(0) ? Eigen::Vector3d(1, 0, 0) : direction);
    curve.information.push_back(link->vertices[k].information);
    curve.footprint.push_back(link->vertices[k].footprint);
  }
  link->points_in_world = SmoothCurve(curve, link->closed, bending_sigma_px);
  if (link->closed) link->points_in_world.push_back(link->points_in_world.front());
}

void MoveNodes(DrawingGraph* graph) {
  GraphEditor editor(graph);
  for (NodeId id = 0; id < static_cast<NodeId>(graph->nodes.size()); ++id) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const DrawingNode& node = graph->nodes[id];
    for (const LinkEnd& end : node.incident) sum += EndPoint(graph->links[end.link], end.end);
    editor.MoveNode(id, sum / node.Degree());
  }
}

void SetSigmas(DrawingGraph* graph) {
  for (DrawingLink& link : graph->links) {
    for (int k = 0; k < link.size(); ++k) {
      link.sigma[k] = SigmaAcross(link.vertices[k].information, link.vertices[k].footprint);
    }
  }
}

}  // namespace

void SmoothLinks(double bending_sigma_px, DrawingGraph* graph) {
  for (DrawingLink& link : graph->links) Smooth(bending_sigma_px, &link);
  PlaceNodes(graph);
}

void PlaceNodes(DrawingGraph* graph) {
  SetSigmas(graph);
  MoveNodes(graph);
}

}  // namespace limn
