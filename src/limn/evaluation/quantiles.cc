// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/quantiles.h"

#include <algorithm>

namespace limn {

std::optional<double> WeightedQuantile(std::vector<WeightedValue> values, double share) {
  double total = 0;
  for (const auto& [value, weight] : values) total += weight;
  if (!(total > 0)) return std::nullopt;
  std::sort(values.begin(), values.end());
  double below = 0;
  for (const auto& [value, weight] : values) {
    below += weight;
    if (below >= share * total) return value;
  }
  return values.back().first;
}

std::optional<double> Quantile(const std::vector<double>& values, double share) {
  std::vector<WeightedValue> weighted;
  weighted.reserve(values.size());
  for (const double value : values) weighted.emplace_back(value, 1.0);
  return WeightedQuantile(std::move(weighted), share);
}

}  // namespace limn
