// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// A unit of length in which pixel footprints of the drawing are near 1 / 1024, as in models
// normalized by COLMAP: the power of two next to 1024 times the median footprint of the links. 1
// without links. Ceres has absolute constants (the damping of its steps); products with powers of
// two are exact.
double SceneUnit(const std::vector<View>& views, const DrawingGraph& graph);

// The same scene with all lengths multiplied. The links of the graph have no vertices.
std::vector<View> Scaled(std::vector<View> views, double factor);
DrawingGraph Scaled(DrawingGraph graph, double factor);

}  // namespace limn
