// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "limn/topology/graph_editor.h"

namespace limn {

// Splits links where they turn sharply between straight arms, so that the next fit does not round
// the corner (algorithm/refinement.md#repairs-between-fits). Points must be about 1 px apart; loops
// and links without vertices are left alone. Returns the number of cuts. Linear time.
int64_t SplitAtCorners(GraphEditor* editor);

}  // namespace limn
