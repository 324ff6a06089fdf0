// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/pictures/canvas.h"

namespace limn {

// The mark of a node if the view contains it: a white disc for a junction, a small yellow square
// for an end, a cyan diamond for a loop anchor, each with a dark rim.
void DrawNode(const View& view, const DrawingNode& node, double radius_px, Canvas* canvas);

}  // namespace limn
