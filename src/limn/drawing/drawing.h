// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/drawing/drawing_options.h"
#include "limn/model/curve3d.h"
#include "limn/model/curves_scene.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/edgel_fate.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

struct DrawingInput {
  CurvesScene scene;
  const CurveSketch& sketch;  // its support lists point into the curves of the scene
};

struct DrawingResult {
  DrawingGraph graph;
  SampleFates fates;
  StageSummary summary;
};

// The 3D drawing (ours). Re-triangulates the samples of the sketch from all their edgels
// (Retriangulate, algorithm/drawing.md#re-triangulation), traces links on their consensus
// (TraceCurves), and completes the drawing (CompleteDrawing). The graph passes Validate().
DrawingResult BuildDrawing(const DrawingInput& input, const DrawingOptions& options,
                           const RunContext& context);

// The summary of input and finished graph, common to all methods.
StageSummary SummarizeDrawing(const CurveSketch& sketch, const DrawingGraph& graph);

}  // namespace limn
