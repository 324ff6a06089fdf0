#pragma once

#include <cstdint>

#include "limn/topology/graph_editor.h"

namespace limn {

// Links are cut where they turn sharply between straight arms, so that a fit does not round the
// corner. Points must be about 1 px apart; links without vertices and loops are left alone. Returns
// the number of cuts. Linear time.
int64_t SplitAtCorners(GraphEditor* editor);

}  // namespace limn
