#include "limn/drawing/link_fitting.h"

#include <algorithm>

#include <Eigen/LU>

#include "limn/drawing/curve_smoothing.h"
#include "limn/geometry/tangent_frame.h"
#include "limn/topology/graph_editor.h"
#include "limn/topology/link_geometry.h"

namespace limn {
namespace {

// Weighted mean, across the curve, of the samples merged into a vertex.
void MoveToMean(const SampleSet& samples, const LinkVertex& vertex, Eigen::Vector3d* position) {
  if (vertex.samples.empty()) return;
  const Eigen::Vector3d& tangent = samples.tangent[samples.IdOf(vertex.samples.front())];
  const Eigen::Matrix<double, 3, 2> across = TangentFrame(tangent);
  Eigen::Matrix2d sum = WeakInformation(vertex.footprint) * Eigen::Matrix2d::Identity();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const SketchSample& sample : vertex.samples) {
    const int s = samples.IdOf(sample);
    const Eigen::Matrix2d weight = across.transpose() * samples.information[s] * across;
    sum += weight;
    right += weight * (across.transpose() * (samples.position[s] - *position));
  }
  *position += across * sum.inverse() * right;
}

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

void Describe(const SampleSet& samples, const CurveConsistency& network, LinkVertex* vertex) {
  for (const SketchSample& sample : vertex->samples) {
    vertex->agreeing_views = std::max(vertex->agreeing_views,
                                      CountAgreeingViews(samples, network, samples.IdOf(sample)));
  }
  NameInSketch(samples, vertex);
}

// Moves nodes to the mean of their link ends after the fit.
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
  SetSigmas(graph);
  MoveNodes(graph);
}

void FitLinks(const SampleSet& samples, const CurveConsistency& network,
              const DrawingOptions& options, DrawingGraph* graph) {
  for (DrawingLink& link : graph->links) {
    for (int k = 0; k < link.size(); ++k) {
      MoveToMean(samples, link.vertices[k], &link.points_in_world[k]);
      Describe(samples, network, &link.vertices[k]);
    }
  }
  if (options.IsPaper()) {
    SetSigmas(graph);
    MoveNodes(graph);
  } else {
    SmoothLinks(options.bending_sigma_px, graph);
  }
}

}  // namespace limn
