// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace limn {

// Cells [begin, end) of a curve; on a closed curve of n cells, end may exceed n and wraps around.
using CellRun = std::pair<int, int>;

// The runs of cells with flag 1, ascending, after closing gaps of at most `max_gap` cells between
// them and then dropping runs of fewer than `min_length` cells. On a closed curve the last cell is
// followed by the first. Linear time.
std::vector<CellRun> KeptRuns(const std::vector<uint8_t>& flags, bool closed, double max_gap,
                              double min_length);

}  // namespace limn
