// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

// Sets the covariances of the nodes' positions (algorithm/belief.md#nodes): what the links that end
// there tell across themselves, cameras included where these were refined, and how well the end of
// an edge is seen along it. Zero, unknown, where no link has a known sigma. Needs sigmas. Linear in
// link ends times views.
void MeasureNodes(const std::vector<View>& views, const RunContext& context, DrawingGraph* graph);

}  // namespace limn
