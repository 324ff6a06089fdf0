#pragma once

#include <cstdint>
#include <vector>

#include "limn/refinement/control_graph.h"

namespace limn {

// Per link 0 if others run along nearly all of it, within a pixel and parallel: the fit has shown
// that they are the same edge. The shorter of two goes. O(n log n) in the length of all links, px.
std::vector<uint8_t> FindUncoveredLinks(const ControlGraph& control);

}  // namespace limn
