#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "limn/drawing/drawing_options.h"
#include "limn/model/curve3d.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/edgel_fate.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

// `curves[v]` belongs to `views[v]`; the sketch's support lists point into `curves`.
struct DrawingInput {
  const std::vector<View>& views;
  const std::vector<ImageCurves>& curves;
  const CurveSketch& sketch;
  // Links do not grow out of this box.
  std::optional<Eigen::AlignedBox3d> box = std::nullopt;
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
