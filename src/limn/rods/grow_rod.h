// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "limn/model/view_finder.h"
#include "limn/rods/rod.h"
#include "limn/topology/topology_input.h"

namespace limn {

// Extends a rod at both ends as long as enough views show both outlines along the way, over gaps of
// up to 12 px, such as where another rod passes. Stops at the box, and where it comes back to
// itself or runs along one of `others`. Time: length of what is added, px, times views.
void GrowRod(const TopologyInput& input, const ViewFinder& finder, std::span<const Rod> others,
             Rod* rod);

}  // namespace limn
