// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "limn/model/curve_fragment.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// Per view and edgel, whether it stands still: at the same pixels, in the same direction, in many
// images from different places. Burnt-in text does, what carries the camera, and the background
// before which an object turns; but also what slides along itself, as the rim of a turntable.
using StillEdgels = std::vector<std::vector<uint8_t>>;

// Compares images of the same size, of panoramas the same parts, from places that see the middle of
// the drawing from different directions; six are needed. Ours (algorithm/belief.md#still-edgels).
// Time: edgels, and the square of the number of views. Memory: 6 bytes per px.
StillEdgels FindStillEdgels(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                            const DrawingGraph& graph);

// Of all edgels.
double StillShare(const StillEdgels& still);

}  // namespace limn
