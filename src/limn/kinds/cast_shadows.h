// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

// Per link, the share of its length, 0 to 1, that lies behind another link, on lines that coincide,
// as a light of the scene, sun or lamp, sees it: from there the border of a cast shadow lies behind
// the edge that casts it (ours; algorithm/kinds.md#cast-shadows). 0 for links of at most 12 px,
// for tentative ones, and where no light is found. Time: FindLights.
std::vector<double> SharesBehind(const DrawingGraph& graph, const std::vector<View>& views,
                                 const RunContext& context);

}  // namespace limn
