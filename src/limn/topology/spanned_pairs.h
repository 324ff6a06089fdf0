// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>
#include <vector>

#include "limn/topology/joints.h"
#include "limn/util/parallel.h"

namespace limn {

// Two joints, by index.
struct JointPair {
  int from = -1;
  int to = -1;  // greater

  auto operator<=>(const JointPair&) const = default;
};

// Pairs of joints between which a straight stretch of one fragment runs in at least `min_views`
// views, ascending (algorithm/topology.md#long-edges). Time: joints times views, plus, per
// fragment, the square of the number of joints on it.
std::vector<JointPair> FindSpannedPairs(const TopologyInput& input,
                                        const std::vector<Joint>& joints, int min_views,
                                        const RunContext& context);

}  // namespace limn
