#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace limn {

// [begin, end) of cells of a curve; on a closed curve of n cells end may be beyond n and means
// end - n on the next round.
using CellRun = std::pair<int, int>;

// The runs of cells with flag 1 after gaps of at most `max_gap` cells between two such runs have
// been closed and runs of fewer than `min_length` cells dropped, ascending. On a closed curve the
// last cell is followed by the first. Linear.
std::vector<CellRun> KeptRuns(const std::vector<uint8_t>& flags, bool closed, double max_gap,
                              double min_length);

}  // namespace limn
