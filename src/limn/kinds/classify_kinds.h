// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "limn/kinds/kind_evidence.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/image.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn {

struct KindOfLink {
  LinkKind kind = LinkKind::kUnknown;
  double confidence = 0;
};

// How much views differ in the colors they show: medians over the links of the spread of their
// steadier side, in the views as they are, and without what exposure and white balance explain.
struct SceneLight {
  double variation = 0;
  double change = 0;
};

SceneLight LightOf(const std::vector<KindEvidence>& links);

// Edge, paint or shadow (algorithm/kinds.md#classes); unknown without enough profiles.
KindOfLink Classify(const KindEvidence& evidence, const SceneLight& light);

struct KindsInput {
  const std::vector<View>& views;
  // The stored photograph of a view. Thread-safe.
  const std::function<Image(ViewId)>& read_image;
  const DrawingGraph& graph;
};

struct KindsResult {
  DrawingGraph graph;
  StageSummary summary;
};

// Classifies every link as a kind of edge, by what the images show on its two sides (ours;
// algorithm/kinds.md). Contours and rods, which are known already, stay so. Reads every image that
// supports a link once; at most one image per thread is in memory. Throws what read_image throws,
// and Cancelled.
KindsResult ClassifyKinds(const KindsInput& input, const RunContext& context);

}  // namespace limn
