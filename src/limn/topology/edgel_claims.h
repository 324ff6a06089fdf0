// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>
#include <span>
#include <vector>

#include "limn/model/curve_fragment.h"
#include "limn/model/drawing_graph.h"
#include "limn/topology/topology_input.h"
#include "limn/util/parallel.h"

namespace limn {

// A point of a link.
struct LinkPoint {
  LinkId link = -1;
  int index = -1;

  auto operator<=>(const LinkPoint&) const = default;
};

// Per view and edgel, a point of a link that the edgel supports; link -1 if it supports none.
using EdgelClaims = std::vector<std::vector<LinkPoint>>;

// Time: the edgels of all views and the support of all vertices.
EdgelClaims CollectClaims(const TopologyInput& input, const DrawingGraph& graph);

// Returns whether the edgel at an index of a fragment, or one up to kClaimedNeighbors from it on
// the fragment, supports a link. `claims` are those of the fragment's view.
bool IsClaimed(const CurveFragment& fragment, int index, std::span<const LinkPoint> claims);

// Per view, the edgels of fragments that are not claimed.
std::vector<EdgelIndex> UnclaimedEdgels(const TopologyInput& input, const DrawingGraph& graph,
                                        const RunContext& context);

}  // namespace limn
