// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/rods/rod.h"
#include "limn/rods/rod_evidence.h"

namespace limn {

struct FoundRod {
  Rod rod;
  RodEvidence evidence;
  std::vector<ViewId> views;  // that show it, ascending
};

// Adds rods to a drawing as links. Believed links along them, cut where they leave a rod for more
// than some px, become their outlines: tentative, and doubted as such. Returns their number. Ends
// of rods that touch are at one node. Time: points of the links near each rod, times its axis
// points.
int64_t DrawRods(std::span<const FoundRod> rods, DrawingGraph* graph);

}  // namespace limn
