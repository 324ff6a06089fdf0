// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/model/drawing_graph.h"

namespace limn {

// Smooths links as samples are (algorithm/drawing.md#smoothing), then places nodes. Linear in the
// number of points.
void SmoothLinks(double bending_sigma_px, DrawingGraph* graph);

// Sets the sigmas of links whose points have moved from the information at their vertices, and
// moves nodes to the mean of their ends.
void PlaceNodes(DrawingGraph* graph);

}  // namespace limn
