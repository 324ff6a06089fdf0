// SPDX-License-Identifier: BSD-3-Clause
#include "bench/stage_table.h"

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "bench/markdown.h"
#include "limn/util/median.h"

namespace limn::bench {
namespace {

std::string MedianAndSpread(const Json& runs, int digits) {
  const auto values = runs.get<std::vector<double>>();
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const std::string median = Fixed(Median(values), digits);
  if (values.size() == 1) return median;
  return median + " (" + Fixed(*low, digits) + " to " + Fixed(*high, digits) + ")";
}

size_t MostTaus(const Json& report) {
  size_t most = 0;
  for (const Json& set : report["sets"]) most = std::max(most, set["taus"].size());
  return most;
}

Cells StageCells(const Json& set, const Json& stage, size_t num_taus) {
  Cells cells = {set["name"], stage["stage"], MedianAndSpread(stage["seconds"], 2),
                 MedianAndSpread(stage["cpu_seconds"], 2), MedianAndSpread(stage["peak_mb"], 0)};
  const Json& truth = stage["truth"];
  for (size_t i = 0; i < num_taus; ++i) {
    const bool known = !truth.is_null() && i < set["taus"].size();
    cells.push_back(known ? Shares(truth.begin().value()[i]) : "");
  }
  return cells;
}

void PrintTaus(const Json& report, std::ostream& out) {
  for (const Json& set : report["sets"]) {
    if (set["taus"].empty()) continue;
    out << "- " << set["name"].get<std::string>() << ": tau";
    for (const Json& tau : set["taus"]) out << ' ' << Short(tau);
    out << " (" << set["unit"].get<std::string>() << ")\n";
  }
  out << '\n';
}

}  // namespace

void WriteStageTable(const Json& report, std::ostream& out) {
  out << "# Stages, commit " << report["commit"].get<std::string>() << "\n\n";
  PrintTaus(report, out);
  const size_t num_taus = MostTaus(report);
  Cells heads = {"set", "stage", "s", "CPU s", "peak MB"};
  for (size_t i = 0; i < num_taus; ++i) {
    heads.push_back("P / R / F at tau " + std::to_string(i + 1));
  }
  PrintHead(heads, out);
  for (const Json& set : report["sets"]) {
    for (const Json& stage : set["stages"]) PrintRow(StageCells(set, stage, num_taus), out);
  }
}

}  // namespace limn::bench
