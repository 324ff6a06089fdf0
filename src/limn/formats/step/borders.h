// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/formats/step/border_graph.h"
#include "limn/formats/step/sheets.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// Cuts links wherever an edge of a sheet begins or ends; places nearer than 0.1 % of the link are
// one. Vertices are moved to where the planes of their faces meet. Loops of planes that pass a
// vertex twice become several. Sheets whose border has gaps of more than `max_gap_rel` of their
// size, of planes along them, are left out. Time n log n in edges and points of borders, n^2 in the
// edges of a loop.
FaceBorders MakeFaceBorders(const DrawingGraph& graph, const std::vector<StepSheet>& sheets,
                            double max_gap_rel);

}  // namespace limn
