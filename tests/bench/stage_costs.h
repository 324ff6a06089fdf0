// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "bench/json.h"
#include "bench/stopwatch.h"

namespace limn::bench {

// What a stage took.
struct StageCost {
  std::string stage;
  Times times;
  // The most memory the program held while the stage ran, MB, what it held before included.
  double peak_mb = 0;
};

// Measures one stage, from its construction on. What earlier stages and measurements freed is given
// back to the system first, so that it counts for nobody. The peak is that since construction where
// /proc/self/clear_refs can be written, else since the program began.
class StageMeter {
 public:
  StageMeter();
  StageCost Finish(const std::string& stage) const;

 private:
  Stopwatch stopwatch_;
};

// The report of stages, which scripts/compare_commits.sh compares. Keys are only ever added:
//   format    "limn stages 2"; 1 had images at their own size, and other stages
//   commit    what was measured, as git describes it; "" if unknown
//   threads   -1: all cores
//   sets      [{name, num_views, unit, taus, stages}]
//   stages    [{stage, seconds, cpu_seconds, peak_mb, truth}] in the order of their first run, last
//             "total": sums, and the largest peak
//   seconds, cpu_seconds, peak_mb   one number per run of the stage
//   truth     {box: [{tau, precision, recall, f, junction_precision, junction_recall}]}; null where
//             there is no truth, or nothing was measured. Runs give the same
Json NewStageReport(const std::string& commit, int num_threads);
Json NewStageSet(const std::string& name, size_t num_views, const std::string& unit,
                 const std::vector<double>& taus);

// One more run of a stage.
void AddCost(const StageCost& cost, Json* set);

// What MeasureAgainstTruth gives of the curves after a stage.
void AddTruth(const std::string& stage, const Json& truth, Json* set);

// "total" of all stages so far, each of which ran as often as the others.
void AddTotal(Json* set);

}  // namespace limn::bench
