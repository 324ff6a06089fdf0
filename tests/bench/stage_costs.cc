// SPDX-License-Identifier: BSD-3-Clause
#include "bench/stage_costs.h"

#include <algorithm>
#include <fstream>

#include <malloc.h>
#include <sys/resource.h>

namespace limn::bench {
namespace {

double PeakMemoryMb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

Json* FindStage(const std::string& name, Json* set) {
  Json& stages = (*set)["stages"];
  for (Json& stage : stages) {
    if (stage["stage"] == name) return &stage;
  }
  stages.push_back({{"stage", name},
                    {"seconds", Json::array()},
                    {"cpu_seconds", Json::array()},
                    {"peak_mb", Json::array()},
                    {"truth", nullptr}});
  return &stages.back();
}

// What a report of stages keeps of that of an evaluation.
Json ShortTruth(const Json& boxes) {
  Json kept = Json::object();
  for (const auto& [box, report] : boxes.items()) {
    kept[box] = Json::array();
    for (const Json& row : report["rows"]) {
      Json entry;
      for (const char* key :
           {"tau", "precision", "recall", "f", "junction_precision", "junction_recall"}) {
        entry[key] = row[key];
      }
      kept[box].push_back(std::move(entry));
    }
  }
  return kept;
}

}  // namespace

StageMeter::StageMeter() {
  malloc_trim(0);
  constexpr char kResetPeak = '5';  // proc(5), clear_refs
  std::ofstream("/proc/self/clear_refs") << kResetPeak;
  stopwatch_ = Stopwatch();
}

StageCost StageMeter::Finish(const std::string& stage) const {
  return {stage, stopwatch_.Elapsed(), PeakMemoryMb()};
}

Json NewStageReport(const std::string& commit, int num_threads) {
  return {{"format", "limn stages 2"},
          {"commit", commit},
          {"threads", num_threads},
          {"sets", Json::array()}};
}

Json NewStageSet(const std::string& name, size_t num_views, const std::string& unit,
                 const std::vector<double>& taus) {
  return {{"name", name},
          {"num_views", num_views},
          {"unit", unit},
          {"taus", taus},
          {"stages", Json::array()}};
}

void AddCost(const StageCost& cost, Json* set) {
  Json& stage = *FindStage(cost.stage, set);
  stage["seconds"].push_back(cost.times.seconds);
  stage["cpu_seconds"].push_back(cost.times.cpu_seconds);
  stage["peak_mb"].push_back(cost.peak_mb);
}

void AddTruth(const std::string& stage, const Json& truth, Json* set) {
  (*FindStage(stage, set))["truth"] = ShortTruth(truth);
}

void AddTotal(Json* set) {
  const Json stages = (*set)["stages"];
  const size_t num_runs = stages.empty() ? 0 : stages[0]["seconds"].size();
  for (size_t run = 0; run < num_runs; ++run) {
    StageCost total{"total", {}, 0};
    for (const Json& stage : stages) {
      total.times = total.times + Times{stage["seconds"][run].get<double>(),
                                        stage["cpu_seconds"][run].get<double>()};
      total.peak_mb = std::max(total.peak_mb, stage["peak_mb"][run].get<double>());
    }
    AddCost(total, set);
  }
}

}  // namespace limn::bench
