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

// The 3D drawing. Re-triangulates the samples of the sketch from all their edgels (ours;
// ALGORITHM.md 7), traces links on their consensus (TraceCurves, ours), and completes the drawing
// (CompleteDrawing, ours). The method "merged" builds the local and the curve-level consistency
// network, averages the curves of each cluster, and merges them into links instead of tracing
// (ECCV 2016, section 3; ALGORITHM.md 8 to 11). The method "paper" does only that, with the samples
// as the sketch has them. The graph passes Validate().
DrawingResult BuildDrawing(const DrawingInput& input, const DrawingOptions& options,
                           const RunContext& context);

}  // namespace limn
