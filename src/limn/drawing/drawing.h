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

// The 3D drawing (ECCV 2016, sections 4 and 5): re-triangulate the samples of the sketch from all
// their edgels, build the local and the curve-level consistency network, average the curves of each
// cluster, merge them into links, find corners and T junctions across clusters, and grow from
// joints and free ends what else the images show. The graph passes Validate().
DrawingResult BuildDrawing(const DrawingInput& input, const DrawingOptions& options,
                           const RunContext& context);

}  // namespace limn
