// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "colmap_ext/model/model.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// Three images of 200 x 100 pixels side by side, 4 in front of the plane z = 0.
SparseModel MakeScene();

// Of photographs of half the size.
std::vector<View> ViewsOf(const SparseModel& model);

// A line, and a bent link that continues it; the node where they meet is seen in all images.
DrawingFile MakeDrawing();

}  // namespace limn::colmap_ext
