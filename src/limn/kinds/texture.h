// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/util/stage_summary.h"

namespace limn {

// Sets curve_px of all links: of a believed one the length of its curve (CurvesOf) as far as it is
// believed, of a tentative link, a contour or a rod its own.
void MeasureCurves(const std::vector<View>& views, DrawingGraph* graph);

// Makes believed links texture that are part of a short curve, among short curves and loose ends
// (ours; algorithm/kinds.md#texture). Contours, rods and closed links stay. Marks of earlier runs
// stay, too: classify the kinds before. Precondition: MeasureCurves. O(n log n) for n pixels of
// links.
StageSummary MarkTexture(const std::vector<View>& views, DrawingGraph* graph);

}  // namespace limn
