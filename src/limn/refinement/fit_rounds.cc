// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/fit_rounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "limn/refinement/curve_fit.h"
#include "limn/refinement/edgel_matches.h"
#include "limn/refinement/variance_factors.h"
#include "limn/util/angles.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// A view supports a link if it shows this many of its samples, or half of them.
constexpr int kMinSupportedSamples = 2;

void SetSupport(const ControlLink& fitted, DrawingLink* link) {
  std::map<ViewId, int> samples;
  for (const FitSample& sample : fitted.samples) {
    for (const EdgelPull& pull : sample.pulls) ++samples[pull.ref.view];
  }
  const int needed = std::min(kMinSupportedSamples, (NumShown(fitted) + 1) / 2);
  link->supporting_views.clear();
  for (const auto& [view, count] : samples) {
    if (count >= needed) link->supporting_views.push_back(view);
  }
  link->residual_px = Median(ResidualsPx(fitted));
}

}  // namespace

FitRounds::FitRounds(const RefinementInput& input, const RefinementOptions& options,
                     const RunContext& context)
    : views(input.scene.views),
      graph(input.graph),
      curves_(input.scene.curves),
      options_(options),
      context_(context),
      edgels_(BuildViewEdgels(input.scene.curves, context)) {
  TakeGraph();
}

void FitRounds::TakeGraph() {
  control = MakeControlGraph(graph, views, options_.control_spacing_px);
}

TopologyInput FitRounds::Images(double reach) const {
  return {views,
          curves_,
          edgels_,
          {reach * options_.max_distance_px, 1.0, options_.max_angle_deg * kDeg}};
}

void FitRounds::Match(double reach) { MatchEdgels(Images(reach), options_, context_, &control); }

void FitRounds::Fit(const FittedLinks& fitted, bool is_last) {
  Match(1);
  FreezeUnshown(&control);
  for (size_t l = 0; l < fitted.size(); ++l) control.links[l].frozen |= !fitted[l];
  FitCurves(views, options_, context_, is_last, &control);
}

void FitRounds::Finish(const FittedLinks& fitted) {
  Match(1);
  SetFinalGeometry(fitted);
  for (size_t l = 0; l < graph.links.size(); ++l) {
    if (!control.links[l].frozen) SetSupport(control.links[l], &graph.links[l]);
  }
}

void FitRounds::SetFinalGeometry(const FittedLinks& fitted) {
  ScaleCovariances();
  SetGeometry(fitted);
}

void FitRounds::SetGeometry(const FittedLinks& fitted) {
  for (size_t n = 0; n < graph.nodes.size(); ++n) {
    graph.nodes[n].position_in_world = control.position[n];
  }
  for (size_t l = 0; l < graph.links.size(); ++l) {
    if (!fitted[l]) continue;
    const ControlLink& link = control.links[l];
    if (link.frozen) {
      KeepShape(link, &graph.links[l]);
    } else {
      SetPoints(link, &graph.links[l]);
    }
  }
}

void FitRounds::ScaleCovariances() {
  const std::vector<double> factors = VarianceFactors(options_, control);
  for (size_t p = 0; p < factors.size(); ++p) {
    if (control.covariance[p]) *control.covariance[p] *= factors[p];
  }
}

// No edgel of an unfitted link is within the gate, so its sigma is at least max_distance_px.
void FitRounds::KeepShape(const ControlLink& unfitted, DrawingLink* link) const {
  FollowEnds(control.position[link->node0], control.position[link->node1], &link->points_in_world);
  double footprint = 0;
  for (const int id : unfitted.points) footprint = std::max(footprint, control.footprint[id]);
  const double least = options_.max_distance_px * footprint;
  for (double& sigma : link->sigma) {
    sigma = std::isfinite(sigma) ? std::max(sigma, least) : least;
  }
}

void FitRounds::SetPoints(const ControlLink& fitted, DrawingLink* link) const {
  link->points_in_world.clear();
  link->sigma.clear();
  for (int k = 0; k <= fitted.NumSegments(); ++k) {
    link->points_in_world.push_back(control.position[fitted.points[k]]);
    link->sigma.push_back(Sigma(fitted, k));
  }
}

// Root of the mean of the two variances across the curve; infinite before there are any.
double FitRounds::Sigma(const ControlLink& link, int k) const {
  const auto& covariance = control.covariance[link.points[k]];
  if (!covariance) return std::numeric_limits<double>::infinity();
  const Eigen::Vector3d tangent = Tangent(control, link, k - 1, k + 1);
  const double along = tangent.dot(*covariance * tangent);
  return std::sqrt(std::max(0.0, 0.5 * (covariance->trace() - along)));
}

}  // namespace limn
