// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/link_fitting.h"

#include <algorithm>

#include <Eigen/LU>

#include "limn/drawing/link_smoothing.h"
#include "limn/geometry/tangent_frame.h"
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

void Describe(const SampleSet& samples, const CurveConsistency& network, LinkVertex* vertex) {
  for (const SketchSample& sample : vertex->samples) {
    vertex->agreeing_views = std::max(vertex->agreeing_views,
                                      CountAgreeingViews(samples, network, samples.IdOf(sample)));
  }
  NameInSketch(samples, vertex);
}

}  // namespace

void FitLinks(const SampleSet& samples, const CurveConsistency& network, DrawingGraph* graph) {
  for (DrawingLink& link : graph->links) {
    for (int k = 0; k < link.size(); ++k) {
      MoveToMean(samples, link.vertices[k], &link.points_in_world[k]);
      Describe(samples, network, &link.vertices[k]);
    }
  }
  PlaceNodes(graph);
}

}  // namespace limn
