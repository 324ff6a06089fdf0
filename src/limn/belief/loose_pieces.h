#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"

namespace limn {

// Doubts (kChance) what hangs together over less than 60 px, has no closed link, and no link with
// an evidence of 11: grain and texture by accident look like this, objects seldom
// (algorithm/belief.md#loose-pieces). Per link, its length and its evidence; links doubted before
// are no part of a piece. Linear time.
void DoubtLoosePieces(const std::vector<double>& length_px, const std::vector<double>& evidence,
                      DrawingGraph* graph);

}  // namespace limn
