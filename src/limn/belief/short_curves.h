// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/util/stage_summary.h"

namespace limn {

// Doubts (kShort) links of short curves that are more likely wrong than right
// (DrawingLink::confidence), or much less likely than the rest if that is uncertain, too: what is
// long and wrong has other reasons (ours; algorithm/belief.md#short-curves). Links that were
// doubted before stay. Linear time. Precondition: TellConfidences, MeasureCurves, no kShort.
StageSummary DoubtShortCurves(const std::vector<View>& views, DrawingGraph* graph);

// Undoes it: links are to be described anew.
void BelieveShortCurves(DrawingGraph* graph);

}  // namespace limn
