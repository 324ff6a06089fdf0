// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/control_graph.h"

#include <algorithm>
#include <cmath>

#include "limn/model/footprint.h"

namespace limn {
namespace {

// Length at a corner, where image edges are rounded, that is not matched, px, and its largest share
// of a link.
constexpr double kCornerSkipPx = 3;
constexpr double kMaxSkippedShare = 0.25;
// A link is fitted if enough views show this share of its samples.
constexpr double kMinShownShare = 0.3;

// Returns whether two ends continue each other and no other link ends here.
bool IsSmooth(const DrawingNode& node) {
  return node.Degree() == 2 && node.continuations.size() == 1;
}

// Returns whether the link end has a smooth continuation.
bool GoesOn(const DrawingNode& node, const LinkEnd& end) {
  return std::any_of(node.continuations.begin(), node.continuations.end(),
                     [&](const auto& pair) { return pair.first == end || pair.second == end; });
}

// A control point at a node or on a link.
void AddPoint(const Eigen::Vector3d& position, double footprint, bool corner,
              ControlGraph* control) {
  control->position.push_back(position);
  control->footprint.push_back(footprint);
  control->corner.push_back(corner);
}

void AddLink(const DrawingGraph& graph, LinkId id, const std::vector<View>& views,
             double spacing_px, ControlGraph* control) {
  const DrawingLink& link = graph.links[id];
  const double unit = LinkFootprint(link, views);
  const double length = Length(link.points_in_world);
  // A link that no camera sees has no footprint: it keeps its two ends.
  const double step = unit > 0 ? spacing_px * unit : length;
  const Polyline3d points =
      ResampleUniform(link.points_in_world, link.closed ? std::min(step, length / 6) : step);
  ControlLink& out = control->links.emplace_back();
  out.views = link.supporting_views;
  out.points.push_back(link.node0);
  for (size_t k = 1; k + 1 < points.size(); ++k) {
    out.points.push_back(static_cast<int>(control->position.size()));
    AddPoint(points[k], LinkFootprint(link, points[k], views), false, control);
  }
  out.points.push_back(link.node1);
  for (const int end : {0, 1}) {
    const NodeId node = link.NodeAt(end);
    double& footprint = control->footprint[node];
    footprint = std::max(footprint, LinkFootprint(link, control->position[node], views));
    if (control->corner[node] && unit > 0 && !GoesOn(graph.nodes[node], {id, end})) {
      out.skip_px[end] = std::min(kCornerSkipPx, kMaxSkippedShare * length / unit);
    }
  }
  for (int k = 1; k < out.NumSegments(); ++k) {
    control->bends.push_back({out.points[k - 1], out.points[k], out.points[k + 1]});
  }
}

void AddBendsThrough(NodeId id, const DrawingNode& node, ControlGraph* control) {
  const auto next_to = [&](const LinkEnd& end) {
    const std::vector<int>& points = control->links[end.link].points;
    return end.end == 0 ? points[1] : points[points.size() - 2];
  };
  for (const auto& [a, b] : node.continuations) {
    const Bend bend = {next_to(a), id, next_to(b)};
    if (bend[0] != bend[1] && bend[1] != bend[2] && bend[0] != bend[2]) {
      control->bends.push_back(bend);
    }
  }
}

}  // namespace

ControlGraph MakeControlGraph(const DrawingGraph& graph, const std::vector<View>& views,
                              double spacing_px) {
  ControlGraph control;
  for (const DrawingNode& node : graph.nodes) {
    AddPoint(node.position_in_world, 0, node.Degree() >= 2 && !IsSmooth(node), &control);
  }
  for (size_t l = 0; l < graph.links.size(); ++l) {
    AddLink(graph, static_cast<LinkId>(l), views, spacing_px, &control);
  }
  for (size_t n = 0; n < graph.nodes.size(); ++n) {
    AddBendsThrough(static_cast<NodeId>(n), graph.nodes[n], &control);
  }
  control.start = control.position;
  control.covariance.resize(control.position.size());
  return control;
}

Eigen::Vector3d Tangent(const ControlGraph& control, const ControlLink& link, int first, int last) {
  const Eigen::Vector3d chord = control.position[link.points[std::min(last, link.NumSegments())]] -
                                control.position[link.points[std::max(first, 0)]];
  return chord.normalized();
}

void UpdateTangents(ControlGraph* control) {
  control->tangent.assign(control->position.size(), Eigen::Vector3d::Zero());
  for (const ControlLink& link : control->links) {
    for (int k = 0; k <= link.NumSegments(); ++k) {
      control->tangent[link.points[k]] = Tangent(*control, link, k - 1, k + 1);
    }
  }
}

std::vector<double> ResidualsPx(const ControlLink& link) {
  std::vector<double> residuals;
  for (const FitSample& sample : link.samples) {
    for (const EdgelPull& pull : sample.pulls) residuals.push_back(std::abs(pull.residual_px));
  }
  return residuals;
}

int NumShown(const ControlLink& link) {
  return static_cast<int>(
      std::ranges::count_if(link.samples, [](const FitSample& s) { return !s.pulls.empty(); }));
}

void FreezeUnshown(ControlGraph* control) {
  for (ControlLink& link : control->links) {
    const int shown = NumShown(link);
    link.frozen = shown == 0 || shown < kMinShownShare * static_cast<double>(link.samples.size());
  }
}

void FollowEnds(const Eigen::Vector3d& first, const Eigen::Vector3d& last, Polyline3d* points) {
  const Eigen::Vector3d moved[2] = {first - points->front(), last - points->back()};
  for (size_t k = 0; k < points->size(); ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(points->size() - 1);
    (*points)[k] += (1 - t) * moved[0] + t * moved[1];
  }
  // Rounding must not part them from their nodes.
  points->front() = first;
  points->back() = last;
}

void FollowNodes(const std::vector<Eigen::Vector3d>& before, ControlGraph* control) {
  for (const ControlLink& link : control->links) {
    if (!link.frozen) continue;
    Polyline3d points;
    for (const int id : link.points) points.push_back(before[id]);
    FollowEnds(control->position[link.points.front()], control->position[link.points.back()],
               &points);
    for (size_t k = 0; k < points.size(); ++k) control->position[link.points[k]] = points[k];
  }
}

}  // namespace limn
