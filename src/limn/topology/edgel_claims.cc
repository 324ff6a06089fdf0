// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/edgel_claims.h"

#include <utility>

#include "limn/topology/fragment_neighbors.h"

namespace limn {

EdgelClaims CollectClaims(const TopologyInput& input, const DrawingGraph& graph) {
  EdgelClaims claims;
  for (const ImageCurves& of_view : input.curves) {
    claims.emplace_back(of_view.edge_map.edgels.size());
  }
  for (LinkId id = 0; id < static_cast<LinkId>(graph.links.size()); ++id) {
    const DrawingLink& link = graph.links[id];
    for (int k = 0; k < static_cast<int>(link.vertices.size()); ++k) {
      for (const EdgelRef& ref : link.vertices[k].support) claims[ref.view][ref.edgel] = {id, k};
    }
  }
  return claims;
}

bool IsClaimed(const CurveFragment& fragment, int index, std::span<const LinkPoint> claims) {
  bool is_claimed = false;
  ForEachNeighbor(fragment, index, kClaimedNeighbors,
                  [&](EdgelId id) { is_claimed |= claims[id].link >= 0; });
  return is_claimed;
}

std::vector<EdgelIndex> UnclaimedEdgels(const TopologyInput& input, const DrawingGraph& graph,
                                        const RunContext& context) {
  const EdgelClaims claims = CollectClaims(input, graph);
  std::vector<EdgelIndex> result(claims.size());
  ParallelFor(context, "unclaimed edgels", claims.size(), [&](size_t v) {
    std::vector<bool> unclaimed = LinkedEdgels(input.curves[v]);
    for (const CurveFragment& fragment : input.curves[v].fragments) {
      for (int i = 0; i < static_cast<int>(fragment.edgel_ids.size()); ++i) {
        if (IsClaimed(fragment, i, claims[v])) unclaimed[fragment.edgel_ids[i]] = false;
      }
    }
    result[v] = input.edgels[v]->edgels.Subset(std::move(unclaimed));
  });
  return result;
}

}  // namespace limn
