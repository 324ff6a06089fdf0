// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/surfaces/face_links.h"

namespace limn {

// A link of a loop.
struct LoopStep {
  const FaceLink* link = nullptr;
  bool reversed = false;  // the loop runs against it
};

using BentLoop = std::vector<LoopStep>;

// All points of its links in order; those where two meet are there twice.
Polyline3d PointsOf(const BentLoop& loop, const DrawingGraph& graph);

// Loops of links that a bent surface may have as its border (ours;
// algorithm/surfaces.md#ruled-faces-and-patches): two to six links, at least one of them bent, not
// in a plane, each within max_bridge_px of the next. No node is met twice, and no other link joins
// two nodes across. The surface bends smoothly: at corners the loop turns to the same side, around
// normals within 60 degrees of those at the corners before. Each loop once. `links` must outlive
// the result. Time: bent links times ways of five links.
std::vector<BentLoop> FindBentLoops(const std::vector<FaceLink>& links, const DrawingGraph& graph,
                                    const SurfaceOptions& options);

}  // namespace limn
