// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/model/curves_scene.h"
#include "limn/model/drawing_graph.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

// The supporting views of the links are ids of the scene's views.
struct OutlinesInput {
  CurvesScene scene;
  const DrawingGraph& graph;
  bool fit_bodies = true;
};

struct OutlinesResult {
  DrawingGraph graph;
  StageSummary summary;
};

// Finds the links that are outlines of smooth bodies, of which every view sees another curve, and
// makes them contours (ours; algorithm/kinds.md#smooth-bodies). A body, round across the link, must
// explain the edgels of all views better than an edge in space, and outlines on two other links
// must agree on it, unless it is much better alone. Tentative links and rods stay. Contours of an
// earlier run are judged anew. Where outlines that agree are those of a sphere, cylinder or cone,
// they have it as their body (FitRoundBody). Throws Cancelled. Time: that of CompareWithBodies for
// each link, and the square of the number of outlines.
OutlinesResult FindSmoothOutlines(const OutlinesInput& input, const RunContext& context);

// The drawing without contours: their kind is unknown, without a body.
DrawingGraph WithoutOutlines(DrawingGraph graph);

}  // namespace limn
