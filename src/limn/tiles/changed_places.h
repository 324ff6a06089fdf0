// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "limn/model/curve3d.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// A drawing, and what has changed since it was made: views that came and views that went.
struct ChangedScene {
  const std::vector<View>& views;
  // Supporting views are those that are left. Links have primitives or none.
  const DrawingGraph& graph;
  // Links to be redrawn because they lost too much support.
  const std::vector<uint8_t>& lost;
  // The sketch of all views, and which of its views are new, per view.
  const CurveSketch& sketch;
  const std::vector<uint8_t>& is_new;
};

// A part of space to be redrawn.
struct ChangedPlace {
  Eigen::AlignedBox3d core;   // what is replaced; cores do not overlap
  Eigen::AlignedBox3d reach;  // what is drawn, so that curves near the border have surroundings
};

// Where the drawing must be redone (algorithm/tiles.md#updates): along links that are lost, and
// where new views show curves that it lacks, which few others have shown before: enough of all
// views agree on them now, and few enough of the old ones that the old drawing is not already known
// to fail there. Time: samples times log(new samples).
std::vector<ChangedPlace> FindChangedPlaces(const ChangedScene& scene);

}  // namespace limn
