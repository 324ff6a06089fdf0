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

// The 3D drawing (ECCV 2016, section 3): re-triangulate the samples of the sketch from all their
// edgels (ours), build the local and the curve-level consistency network, average the curves of
// each cluster, and merge them into links; then complete the drawing by what is ours
// (CompleteDrawing). The graph passes Validate().
DrawingResult BuildDrawing(const DrawingInput& input, const DrawingOptions& options,
                           const RunContext& context);

}  // namespace limn
