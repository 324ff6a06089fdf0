// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "limn/refinement/control_graph.h"
#include "limn/refinement/edge_links.h"
#include "limn/refinement/fit_rounds.h"
#include "limn/refinement/refinement.h"
#include "limn/refinement/scene_unit.h"

namespace limn {
namespace {

// Nodes of links that stay are as uncertain as the ends of these links.
void HoldOthers(const FittedLinks& fitted, double max_distance_px, const DrawingGraph& graph,
                ControlGraph* control) {
  control->held.resize(control->position.size());
  for (size_t l = 0; l < graph.links.size(); ++l) {
    if (fitted[l]) continue;
    const DrawingLink& link = graph.links[l];
    for (const int end : {0, 1}) {
      const NodeId node = link.NodeAt(end);
      const double sigma = end == 0 ? link.sigma.front() : link.sigma.back();
      const double unknown = max_distance_px * control->footprint[node];
      std::optional<double>& held = control->held[node];
      held = std::min(held.value_or(std::numeric_limits<double>::infinity()),
                      std::isfinite(sigma) && sigma > 0 ? sigma : unknown);
    }
  }
}

// In units of the scene, of a graph without outlines of smooth bodies.
RefitResult RefitEdges(const RefinementInput& input, const FittedLinks& refit,
                       const RefinementOptions& options, const RunContext& context) {
  FitRounds rounds(input, options, context);
  HoldOthers(refit, options.max_distance_px, rounds.graph, &rounds.control);
  for (int round = 0; round < options.num_rounds; ++round) {
    rounds.Fit(refit, round + 1 == options.num_rounds);
  }
  rounds.Finish(refit);
  RefitResult result;
  for (size_t l = 0; l < refit.size(); ++l) {
    const ControlLink& link = rounds.control.links[l];
    result.fitted.push_back(!link.frozen);
    auto& shown = result.shown.emplace_back();
    if (!refit[l]) continue;
    for (const FitSample& sample : link.samples) {
      shown.push_back({sample.position, static_cast<int>(sample.pulls.size())});
    }
  }
  result.graph = std::move(rounds.graph);
  return result;
}

// Puts a fitted link into a drawing that has its ends at nodes of its own.
void PutFitted(const DrawingLink& from, const std::vector<DrawingNode>& nodes, LinkId id,
               DrawingGraph* graph) {
  DrawingLink& link = graph->links[id];
  link.points_in_world = from.points_in_world;
  link.sigma = from.sigma;
  link.supporting_views = from.supporting_views;
  link.residual_px = from.residual_px;
  graph->nodes[link.node0].position_in_world = nodes[from.node0].position_in_world;
  graph->nodes[link.node1].position_in_world = nodes[from.node1].position_in_world;
}

}  // namespace

RefitResult RefitLinks(const RefinementInput& input, const std::vector<uint8_t>& refit,
                       const RefinementOptions& options, const RunContext& context) {
  options.Check();
  const size_t num_links = input.graph.links.size();
  RefitResult result = {input.graph, std::vector<uint8_t>(num_links, 0), {}};
  result.shown.resize(num_links);
  if (options.num_rounds == 0) return result;
  const std::vector<uint8_t> are_edges = AreEdges(input.graph);
  DrawingGraph edges = input.graph;
  RemoveLinks(are_edges, &edges);
  std::vector<LinkId> ids;  // of the edges
  std::vector<uint8_t> refit_edges;
  for (size_t l = 0; l < num_links; ++l) {
    if (!are_edges[l]) continue;
    ids.push_back(static_cast<LinkId>(l));
    refit_edges.push_back(refit[l]);
  }
  const double unit = SceneUnit(input.scene.views, edges);
  const std::vector<View> views = Scaled(input.scene.views, 1 / unit);
  edges = Scaled(std::move(edges), 1 / unit);
  RefitResult fitted =
      RefitEdges({{views, input.scene.curves}, edges}, refit_edges, options, context);
  fitted.graph = Scaled(std::move(fitted.graph), unit);
  for (size_t e = 0; e < ids.size(); ++e) {
    if (!refit_edges[e]) continue;
    PutFitted(fitted.graph.links[e], fitted.graph.nodes, ids[e], &result.graph);
    result.fitted[ids[e]] = fitted.fitted[e];
    for (ShownPlace& place : fitted.shown[e]) place.position *= unit;
    result.shown[ids[e]] = std::move(fitted.shown[e]);
  }
  // Outlines end where their nodes have gone.
  for (size_t l = 0; l < num_links; ++l) {
    DrawingLink& link = result.graph.links[l];
    FollowEnds(result.graph.nodes[link.node0].position_in_world,
               result.graph.nodes[link.node1].position_in_world, &link.points_in_world);
  }
  return result;
}

}  // namespace limn
