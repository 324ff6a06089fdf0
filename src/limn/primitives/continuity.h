// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/primitives/shape_fit.h"

namespace limn {

// Per link the conditions at its ends, which are held at nodes shared with other links.
std::vector<EndConditions> EndsOfLinks(const DrawingGraph& graph);

// Gives the ends of splines that continue another link, or themselves, a common direction
// (algorithm/primitives.md#nodes): that of the other link if it is a line or arc, else the mean of
// both. Links whose directions differ by more than 20 degrees keep their own. `shapes` holds one
// entry per link, null if it has none.
void ShareDirections(const DrawingGraph& graph, const std::vector<const CurveShape*>& shapes,
                     std::vector<EndConditions>* ends);

}  // namespace limn
