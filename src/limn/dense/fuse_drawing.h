// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "limn/dense/curve_points.h"
#include "limn/dense/dense_options.h"
#include "limn/dense/dense_point.h"
#include "limn/dense/depth_trust.h"
#include "limn/dense/link_classes.h"
#include "limn/dense/sample_sights.h"
#include "limn/model/drawing_graph.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

struct FusionInput {
  const std::vector<View>& views;
  const DrawingGraph& graph;
  DepthSource depths;
  // Each view has depths of its own, as depth maps are: those of some may be wrong.
  bool depths_are_separate = false;
  // Decides which samples have a dense point nearby; without it the depths decide.
  std::optional<DensePointStream> cloud;
};

struct FusionResult {
  DrawingGraph graph;  // with the dense class of every link
  DrawingSamples samples;
  DenseClasses classes;
  std::vector<CurvePoint> points;  // for the links that are not behind the surface
  DepthTrust trust;
  StageSummary summary;
};

// Compares a drawing with dense results (algorithm/dense.md): visibility of its samples, classes of
// its links, and the points it adds. Depths that are not those of the drawing judge nothing. Throws
// OptionError and Cancelled, and whatever the sources throw. Time: samples times views, and one
// pass over the cloud.
FusionResult FuseDrawing(const FusionInput& input, const DenseOptions& options,
                         const RunContext& context);

// The links that are not behind the surface.
DrawingGraph WithoutOccluded(const DrawingGraph& graph);

}  // namespace limn
