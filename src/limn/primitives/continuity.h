#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/primitives/shape_fit.h"

namespace limn {

// Per link the conditions at its ends: held where other links are.
std::vector<EndConditions> EndsOfLinks(const DrawingGraph& graph);

// Give the ends of splines that continue another link, or themselves, the direction they share:
// that of the other if it is a line or arc, else their mean. Links keep their own direction where
// the two differ by more than 20 degrees. `shapes` as the links; null: none.
void ShareDirections(const DrawingGraph& graph, const std::vector<const CurveShape*>& shapes,
                     std::vector<EndConditions>* ends);

}  // namespace limn
