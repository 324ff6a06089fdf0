// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/model/curves_scene.h"
#include "limn/model/drawing_graph.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

// The supporting views of the links are ids of the scene's views. The graph passes Validate().
struct RodInput {
  CurvesScene scene;
  const DrawingGraph& graph;
};

struct RodResult {
  DrawingGraph graph;
  StageSummary summary;
};

// Finds wires, cables, bars and rods, 1.5 to 7 px thick, straight or bent, and draws their center
// lines as links of kind kRod (ours; algorithm/rods.md). A rod is suggested by two links beside
// each other and fitted to the edgels of all views that show both of its outlines. It must explain
// them better than two lines that are fixed in space, which takes views from different sides. Links
// along it, cut where they leave it, become tentative: LinkDoubt::kRodOutline. Rods have no
// members. Rods that the graph has already are dropped, and their outlines believed again, so that
// all are found anew. The result passes Validate(). Throws Cancelled. Time: pairs of links near
// each other, and length of the rods in px, times views.
RodResult FindRods(const RodInput& input, const RunContext& context);

// The drawing without rods: their outlines are believed.
DrawingGraph WithoutRods(DrawingGraph graph);

}  // namespace limn
