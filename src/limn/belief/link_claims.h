// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/belief/image_evidence.h"
#include "limn/topology/topology_input.h"
#include "limn/util/parallel.h"

namespace limn {

// Decides which link each edgel belongs to (algorithm/belief.md#claims): of the links that it runs
// along, the one that most views show. Clears `own` of the hits on edgels that belong to another
// link, or lie within 1.5 px of one that does and has nearly the same direction, and tells where
// that one is at another depth. Time: hits.
void FindClaims(const TopologyInput& input, const RunContext& context,
                std::vector<ImageEvidence>* links);

}  // namespace limn
