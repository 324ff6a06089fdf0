// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace limn {

// A value and its weight.
using WeightedValue = std::pair<double, double>;

// The smallest value such that it and those below have at least `share`, in [0, 1], of the total
// weight. Nothing if the total weight is not positive. O(n log n).
std::optional<double> WeightedQuantile(std::vector<WeightedValue> values, double share);

// The same with equal weights.
std::optional<double> Quantile(const std::vector<double>& values, double share);

}  // namespace limn
