// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"

namespace limn {

// Views that span this angle measure depth well.
constexpr double kWideAngleDeg = 5;

// The least angle that a link of a drawing with these angles (TriAngleDeg) needs: `min_angle_deg`,
// but where most links span less than kWideAngleDeg the camera hardly moved, small errors of its
// places are large ones of depth, and all links need that. Linear time.
double LeastAngleDeg(const std::vector<double>& angle_deg, double min_angle_deg);

// Doubts (kDepth) links whose views do not measure their depth: by less than `min_angle_deg`, where
// `angle_deg` is that of each link (TriAngleDeg). But a run of such links from one node to another
// has its depth from its ends, if links that were measured meet it at both; a link without an angle
// of its own is as good as what it meets. Links doubted before measure nothing. Linear
// time (algorithm/belief.md#depth).
void DoubtUnmeasuredDepth(const std::vector<double>& angle_deg, double min_angle_deg,
                          DrawingGraph* graph);

}  // namespace limn
