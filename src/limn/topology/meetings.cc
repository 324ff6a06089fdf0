// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/meetings.h"

#include <algorithm>
#include <cmath>

#include "limn/util/angles.h"

namespace limn {
namespace {

// Overshoot allowed, as a share of the gap.
constexpr double kOvershootShare = 0.5;
// Shares of overshoot and miss allowed to fitted links, which are more accurate: 3 and 1.5 px with
// the default options.
constexpr double kFittedOvershoot = 0.5;
constexpr double kFittedMiss = 0.375;
// A curve that turns evenly leaves its direction by half its turn, as a share of the way.
constexpr double kMissPerRad = 0.5;
// Fragments must pass this near to a projected meeting, px. Farther: more false junctions.
constexpr double kNearPx = 6;
// Length of the stretch around a place whose fragments are used, to either side, px.
constexpr double kEndStretchPx = 12;

void CollectFragments(const TopologyInput& input, const LinkVertex& vertex,
                      FragmentsByView* fragments) {
  for (const EdgelRef& ref : vertex.support) {
    (*fragments)[ref.view].insert(input.edgels[ref.view]->place_of[ref.edgel].fragment);
  }
}

void PairAt(double max_turn_rad, const DrawingGraph& graph, DrawingNode* node_at) {
  DrawingNode& node = *node_at;
  const auto known =
      std::find_if(node.incident.begin(), node.incident.end(),
                   [&](const LinkEnd& end) { return !graph.links[end.link].vertices.empty(); });
  if (known == node.incident.end()) return;
  const double footprint = TipOf(graph.links[known->link], known->end).footprint;
  std::vector<LinkTip> tips;
  for (const LinkEnd& end : node.incident) {
    tips.push_back(TipOf(graph.links[end.link], end.end, footprint));
  }
  node.continuations.clear();
  // Of a small ring a tip is a large part.
  if (node.kind == NodeKind::kLoopAnchor && SeamTurn(graph.links[known->link]) < max_turn_rad) {
    node.continuations.push_back({node.incident[0], node.incident[1]});
    return;
  }
  for (const auto& [i, j] : SmoothPairs(tips, max_turn_rad)) {
    node.continuations.push_back({node.incident[i], node.incident[j]});
  }
}

}  // namespace

Reach Reach::Drawn(const TopologyOptions& options) {
  return {options.max_junction_gap_px, kOvershootShare * options.max_junction_gap_px,
          options.max_junction_miss_px};
}

Reach Reach::Fitted(const TopologyOptions& options) {
  Reach reach = Drawn(options);
  reach.overshoot_px *= kFittedOvershoot;
  reach.miss_px *= kFittedMiss;
  return reach;
}

std::optional<Reach::Offset> Reach::To(const LinkTip& tip, const Eigen::Vector3d& place,
                                       double turn_rad) const {
  const Eigen::Vector3d offset = (place - tip.point) / tip.footprint;
  const double along = offset.dot(tip.outward);
  const double miss = (offset - along * tip.outward).norm();
  if (along > gap_px || along < -overshoot_px) return std::nullopt;
  if (miss > miss_px + kMissPerRad * turn_rad * std::abs(along)) return std::nullopt;
  return Offset{along, miss};
}

Places CollectPlaces(const DrawingGraph& graph) {
  Places places;
  for (LinkId id = 0; id < static_cast<LinkId>(graph.links.size()); ++id) {
    const DrawingLink& link = graph.links[id];
    if (link.vertices.empty()) continue;
    for (int k = 0; k < link.size(); ++k) {
      places.position.push_back(link.points_in_world[k]);
      places.point.push_back({id, k});
    }
  }
  return places;
}

FragmentsByView FragmentsAround(const TopologyInput& input, const DrawingLink& link, int index) {
  FragmentsByView fragments;
  if (link.vertices.empty()) return fragments;
  double arc_px = 0;
  for (int k = index; k >= 0 && arc_px <= kEndStretchPx; --k) {
    CollectFragments(input, link.vertices[k], &fragments);
    if (k > 0) arc_px += ArcPx(link, k - 1, k);
  }
  arc_px = 0;
  for (int k = index + 1; k < link.size() && arc_px <= kEndStretchPx; ++k) {
    CollectFragments(input, link.vertices[k], &fragments);
    arc_px += ArcPx(link, k - 1, k);
  }
  return fragments;
}

FragmentsByView FragmentsAtEnd(const TopologyInput& input, const DrawingLink& link, int end) {
  return FragmentsAround(input, link, end == 0 ? 0 : link.size() - 1);
}

bool ImagesAgree(const TopologyInput& input, const Eigen::Vector3d& point, const FragmentsByView& a,
                 const FragmentsByView& b, int min_views) {
  int count = 0;
  for (const auto& [view, fragments] : a) {
    const auto found = b.find(view);
    if (found == b.end()) continue;
    const auto& fragments_a = fragments;  // not the binding: clang 14 cannot capture it
    const auto& fragments_b = found->second;
    const auto pixel = input.views[view].Project(point);
    if (!pixel) continue;
    bool near_a = false;
    bool near_b = false;
    const ViewEdgels& edgels = *input.edgels[view];
    edgels.edgels.ForEachWithin(*pixel, kNearPx, [&](EdgelId id) {
      const int fragment = edgels.place_of[id].fragment;
      near_a |= fragments_a.count(fragment) > 0;
      near_b |= fragments_b.count(fragment) > 0;
    });
    count += near_a && near_b;
  }
  return count >= min_views;
}

void PairContinuations(const TopologyOptions& options, DrawingGraph* graph) {
  const double max_turn_rad = options.max_continuation_angle_deg * kDeg;
  for (DrawingNode& node : graph->nodes) PairAt(max_turn_rad, *graph, &node);
}

}  // namespace limn
