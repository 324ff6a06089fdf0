// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/node_covariance.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/LU>

#include "limn/belief/covariance_across.h"
#include "limn/model/footprint.h"

namespace limn {
namespace {

// Where an edge ends along itself, px: it fades, and is linked to what is near.
constexpr double kEndSigmaPx = 3;
// The direction of a link at its end is that to this point.
constexpr int kDirectionPoints = 4;
// Of the other direction across, where views tell it exactly, relative to the variance.
constexpr double kLeastVariance = 1e-4;

double SigmaAt(const DrawingLink& link, int end) {
  if (link.sigma.empty() || link.kind == LinkKind::kContour) return 0;
  const double sigma = end == 0 ? link.sigma.front() : link.sigma.back();
  return std::isfinite(sigma) ? sigma : 0;
}

std::optional<Eigen::Vector3d> DirectionAt(const DrawingLink& link, int end) {
  const auto& points = link.points_in_world;
  const size_t step = std::min<size_t>(kDirectionPoints, points.size() - 1);
  const Eigen::Vector3d direction = end == 0 ? Eigen::Vector3d(points[step] - points.front())
                                             : points[points.size() - 1 - step] - points.back();
  if (!(direction.norm() > 0)) return std::nullopt;
  return direction.normalized();
}

// What a link tells across itself about where it ends; zero: nothing.
Eigen::Matrix3d InformationOf(const DrawingLink& link, int end, const std::vector<View>& views) {
  const double sigma = SigmaAt(link, end);
  const auto tangent = DirectionAt(link, end);
  if (!(sigma > 0) || !tangent) return Eigen::Matrix3d::Zero();
  const Eigen::Vector3d& point =
      end == 0 ? link.points_in_world.front() : link.points_in_world.back();
  const Eigen::Matrix3d along = *tangent * tangent->transpose();
  const Eigen::Matrix3d across = CovarianceAcross(link, point, *tangent, sigma, views) +
                                 kLeastVariance * sigma * sigma * Eigen::Matrix3d::Identity();
  // The inverse in the plane across: along, what is inverted is taken away again.
  const Eigen::Matrix3d whole = across + sigma * sigma * along;
  const double variance_along = (1 + kLeastVariance) * sigma * sigma;
  return whole.inverse() - along / variance_along;
}

// The ends at a node that tell about it: of firm links, if there are any, and of two that go on in
// each other the first, since one curve was fitted.
std::vector<LinkEnd> TellingEnds(const DrawingGraph& graph, const DrawingNode& node) {
  const auto is_firm = [&](const LinkEnd& end) { return !graph.links[end.link].tentative; };
  const bool has_firm = std::ranges::any_of(node.incident, is_firm);
  std::vector<LinkEnd> telling;
  for (const LinkEnd& end : node.incident) {
    const bool goes_on = std::ranges::any_of(node.continuations, [&](const auto& pair) {
      return pair.second == end && std::ranges::count(telling, pair.first) > 0;
    });
    const bool is_second = std::ranges::count(telling, LinkEnd{end.link, 0}) > 0;
    if (!goes_on && !is_second && (is_firm(end) || !has_firm)) telling.push_back(end);
  }
  return telling;
}

Eigen::Matrix3d CovarianceOf(const DrawingGraph& graph, const DrawingNode& node,
                             const std::vector<View>& views) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  double footprint = 0;
  for (const LinkEnd& at : TellingEnds(graph, node)) {
    const DrawingLink& link = graph.links[at.link];
    information += InformationOf(link, at.end, views);
    footprint = std::max(footprint, LinkFootprint(link, node.position_in_world, views));
  }
  if (!(information.trace() > 0) || !(footprint > 0)) return Eigen::Matrix3d::Zero();
  const double along = kEndSigmaPx * footprint;
  return (information + Eigen::Matrix3d::Identity() / (along * along)).inverse();
}

}  // namespace

void MeasureNodes(const std::vector<View>& views, const RunContext& context, DrawingGraph* graph) {
  ParallelFor(context, "nodes", graph->nodes.size(), [&](size_t n) {
    graph->nodes[n].covariance = CovarianceOf(*graph, graph->nodes[n], views);
  });
}

}  // namespace limn
