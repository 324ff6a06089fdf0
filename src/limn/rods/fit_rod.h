// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

#include "limn/model/view.h"
#include "limn/rods/rod.h"
#include "limn/support/edgel_index.h"
#include "limn/topology/topology_input.h"

namespace limn {

// Moves the axis points from `first` on, across the axis, to where both outlines lie on the edgels
// beside them, by one robust Gauss-Newton step per gate; edgels are looked up anew for every step
// (algorithm/rods.md#fit). Bending is held small where edgels leave it open. The radius is fitted,
// too, if the whole axis is. Time: steps times (places times views + axis points).
void FitRod(const TopologyInput& input, std::span<const ViewId> views,
            std::span<const SupportGate> gates, size_t first, Rod* rod);

}  // namespace limn
