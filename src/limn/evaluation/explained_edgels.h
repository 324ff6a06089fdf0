// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/curve_fragment.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

// What the links that a view supports say of one of its edgels.
struct ExplainedEdgel {
  // Of the links that run along it, the least and the largest depth in the camera; 0 without any.
  float near = 0;
  float far = 0;
  bool is_firm = false;  // whether one of them is firm
};

// Per view and edgel. Links are firm ones and those that better ones explain
// (LinkDoubt::kExplained); outlines of rods stand for rods. `curves[v]` belongs to `views[v]`.
// Time: edgels, and the length of the links in px times their supporting views.
std::vector<std::vector<ExplainedEdgel>> FindExplainedEdgels(const std::vector<View>& views,
                                                             const std::vector<ImageCurves>& curves,
                                                             const DrawingGraph& graph,
                                                             const RunContext& context);

// Of the edgels that links explain, the share that they explain at other depths (AreAtOtherDepths):
// an edge is at one depth only.
double ShareAtOtherDepths(const std::vector<std::vector<ExplainedEdgel>>& explained);

}  // namespace limn
