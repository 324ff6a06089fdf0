#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace limn {

// A value and how much of the whole it stands for.
using WeightedValue = std::pair<double, double>;

// The smallest value such that it and those below it make `share` in [0, 1] of the total weight.
// Nothing if the total weight is not positive. O(n log n).
std::optional<double> WeightedQuantile(std::vector<WeightedValue> values, double share);

// The same with all weights 1.
std::optional<double> Quantile(const std::vector<double>& values, double share);

}  // namespace limn
