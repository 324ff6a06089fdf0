// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "limn/topology/topology_input.h"

namespace limn {

// Edgels on either side along the image curve that support the same point of a link: such points
// are up to 3 px apart in most views. In nearer ones some edgels between remain without a link;
// with two on either side joints find fewer edges (algorithm/refinement.md#what-was-measured).
constexpr int kClaimedNeighbors = 1;

// Calls visit(EdgelId) for an edgel of a fragment and those up to this many places from it.
template <typename Visit>
void ForEachNeighbor(const CurveFragment& fragment, int index, int reach, Visit&& visit) {
  const std::vector<EdgelId>& ids = fragment.edgel_ids;
  const int size = static_cast<int>(ids.size());
  if (fragment.closed && size > 2 * reach) {
    for (int i = index - reach; i <= index + reach; ++i) visit(ids[(i + size) % size]);
    return;
  }
  const int end = std::min(index + reach + 1, size);
  for (int i = std::max(0, index - reach); i < end; ++i) visit(ids[i]);
}

// The same for an edgel that is on a fragment.
template <typename Visit>
void ForEachNeighbor(const TopologyInput& input, const EdgelRef& ref, int reach, Visit&& visit) {
  const auto& [fragment, index] = input.edgels[ref.view]->place_of[ref.edgel];
  ForEachNeighbor(input.curves[ref.view].fragments[fragment], index, reach, visit);
}

}  // namespace limn
