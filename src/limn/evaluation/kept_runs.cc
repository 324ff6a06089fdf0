// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/kept_runs.h"

#include <algorithm>

namespace limn {
namespace {

std::vector<CellRun> RunsOf(const std::vector<uint8_t>& flags, uint8_t value) {
  std::vector<CellRun> runs;
  const int count = static_cast<int>(flags.size());
  for (int i = 0; i < count; ++i) {
    if ((flags[i] != 0) != (value != 0)) continue;
    if (i == 0 || (flags[i - 1] != 0) != (value != 0)) runs.emplace_back(i, i);
    runs.back().second = i + 1;
  }
  return runs;
}

int LengthOf(const CellRun& run) { return run.second - run.first; }

// The cell at which a closed curve is cut open: where the longest gap begins.
int CutOfClosed(const std::vector<uint8_t>& flags) {
  const int count = static_cast<int>(flags.size());
  std::vector<CellRun> gaps = RunsOf(flags, 0);
  if (gaps.empty()) return 0;
  // A gap at the end continues at the start.
  if (gaps.size() > 1 && gaps.front().first == 0 && gaps.back().second == count) {
    gaps.back().second += LengthOf(gaps.front());
  }
  return std::max_element(
             gaps.begin(), gaps.end(),
             [](const CellRun& a, const CellRun& b) { return LengthOf(a) < LengthOf(b); })
      ->first;
}

std::vector<CellRun> KeptRunsOfOpen(std::vector<uint8_t> flags, double max_gap, double min_length) {
  const int count = static_cast<int>(flags.size());
  for (const CellRun& gap : RunsOf(flags, 0)) {
    const bool inner = gap.first > 0 && gap.second < count;
    if (!inner || LengthOf(gap) > max_gap) continue;
    std::fill(flags.begin() + gap.first, flags.begin() + gap.second, uint8_t{1});
  }
  std::vector<CellRun> runs = RunsOf(flags, 1);
  std::erase_if(runs, [&](const CellRun& run) { return LengthOf(run) < min_length; });
  return runs;
}

}  // namespace

std::vector<CellRun> KeptRuns(const std::vector<uint8_t>& flags, bool closed, double max_gap,
                              double min_length) {
  if (!closed) return KeptRunsOfOpen(flags, max_gap, min_length);
  const int count = static_cast<int>(flags.size());
  const int cut = CutOfClosed(flags);
  std::vector<uint8_t> turned = flags;
  std::rotate(turned.begin(), turned.begin() + cut, turned.end());
  std::vector<CellRun> runs = KeptRunsOfOpen(std::move(turned), max_gap, min_length);
  for (CellRun& run : runs) {
    const int begin = (run.first + cut) % count;
    run = {begin, begin + LengthOf(run)};
  }
  std::sort(runs.begin(), runs.end());
  return runs;
}

}  // namespace limn
