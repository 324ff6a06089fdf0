#pragma once

#include <cstdint>
#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/refinement/control_graph.h"

namespace limn {

// Per link 0 if others run along nearly all of it, within a pixel and parallel: the fit has shown
// that they are the same edge. The shorter of two goes. O(n log n) in the length of all links, px.
std::vector<uint8_t> FindUncoveredLinks(const ControlGraph& control);

// Remove the links marked 0 and the nodes that no link is left at; the others keep their order.
void RemoveLinks(const std::vector<uint8_t>& keep, DrawingGraph* graph);

}  // namespace limn
