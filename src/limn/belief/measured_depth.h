#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"

namespace limn {

// Doubts (kDepth) links whose views do not measure their depth: by less than `min_angle_deg`, where
// `angle_deg` is that of each link (TriAngleDeg). But a run of such links from one node to another
// has its depth from its ends, if links that were measured meet it at both; a link without an angle
// of its own is as good as what it meets. Links doubted before measure nothing; contours are left
// out. Linear time (algorithm/belief.md#depth).
void DoubtUnmeasuredDepth(const std::vector<double>& angle_deg, double min_angle_deg,
                          DrawingGraph* graph);

}  // namespace limn
