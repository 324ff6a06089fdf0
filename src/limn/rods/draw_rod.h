#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/rods/rod.h"
#include "limn/rods/rod_evidence.h"
#include "limn/rods/rod_sights.h"

namespace limn {

struct FoundRod {
  Rod rod;
  std::vector<RodPlace> places;
  RodEvidence evidence;
};

// Adds rods to a drawing as links. Believed links along them, cut where they leave a rod for more
// than some px, become their outlines: tentative, and doubted as such. Returns their number. Ends
// of rods that touch are at one node. Linear in the points of all links, per rod.
int64_t DrawRods(std::span<const FoundRod> rods, DrawingGraph* graph);

}  // namespace limn
