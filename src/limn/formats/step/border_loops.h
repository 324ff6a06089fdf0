// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/formats/step/border_graph.h"

namespace limn {

// Splits a loop that passes vertices twice, as where a hole touches the border, into loops that do
// not, the largest first. Only for the writer of STEP files. Time: steps times those of a loop.
std::vector<std::vector<BorderStep>> SimpleLoops(const std::vector<BorderEdge>& edges,
                                                 const std::vector<BorderStep>& steps);

}  // namespace limn
