// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace limn {

// Counts of what a stage did, in the order to be printed. Every input item is accounted for: the
// sum over `kept` and `dropped` of a unit equals its count in `in`.
struct StageSummary {
  using Counts = std::vector<std::pair<std::string, int64_t>>;
  std::string stage;
  Counts in;       // e.g. {"images", 25}, {"edgels", 400123}
  Counts kept;     // e.g. {"fragments", 8123}
  Counts dropped;  // by reason, e.g. {"too few views", 1234}
  std::vector<std::string> warnings;
};

}  // namespace limn
