// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/link_claims.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "limn/support/same_edge.h"

namespace limn {
namespace {

constexpr int kUnclaimed = -1;

// Links that more views show come first.
std::vector<int> ByShowingViews(const std::vector<ImageEvidence>& links) {
  std::vector<int> order(links.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::ranges::greater(),
                           [&](int l) { return links[l].showing_views; });
  return order;
}

// Who owns the edgels of one view.
class Claims {
 public:
  Claims(const TopologyInput& input, ViewId view)
      : edge_map_(input.curves[view].edge_map),
        edgels_(input.edgels[view]->edgels),
        owner_(edge_map_.edgels.size(), kUnclaimed),
        depth_(edge_map_.edgels.size(), 0) {}

  // Tells whose an edgel is. Call it for all hits of a link before it claims any.
  void Judge(int link, float depth, SampleHit* hit) const {
    const Edgel& at = edge_map_.edgels[hit->edgel];
    hit->own = true;
    hit->elsewhere = false;
    edgels_.ForEachWithin(at.position_px, kSameEdgePx, [&](EdgelId near) {
      const bool is_same = std::abs(std::cos(edge_map_.edgels[near].tangent_rad - at.tangent_rad)) >
                           kSameDirectionCosine;
      if (owner_[near] == kUnclaimed || owner_[near] == link || !is_same) return;
      hit->own = false;
      hit->elsewhere |= AreAtOtherDepths(depth, depth_[near]);
    });
  }

  void Claim(int link, float depth, EdgelId edgel) {
    if (owner_[edgel] != kUnclaimed) return;
    owner_[edgel] = link;
    depth_[edgel] = depth;
  }

 private:
  const EdgeMap& edge_map_;
  const EdgelIndex& edgels_;
  std::vector<int> owner_;
  std::vector<float> depth_;  // of the owner
};

}  // namespace

void FindClaims(const TopologyInput& input, const RunContext& context,
                std::vector<ImageEvidence>* links) {
  const std::vector<int> order = ByShowingViews(*links);
  ParallelFor(context, "claimed edgels", input.views.size(), [&](size_t v) {
    const auto view = static_cast<ViewId>(v);
    Claims claims(input, view);
    for (const int l : order) {
      ImageEvidence& evidence = (*links)[l];
      auto& sights = evidence.sights;
      const auto sight = std::ranges::lower_bound(sights, view, {}, &LinkSight::view);
      if (sight == sights.end() || sight->view != view) continue;
      const auto depth_of = [&](const SampleHit& hit) {
        const Eigen::Vector3d& place = evidence.samples[hit.sample].position;
        return static_cast<float>((input.views[v].cam_from_world * place).z());
      };
      for (SampleHit& hit : sight->hits) claims.Judge(l, depth_of(hit), &hit);
      for (const SampleHit& hit : sight->hits) claims.Claim(l, depth_of(hit), hit.edgel);
    }
  });
}

}  // namespace limn
