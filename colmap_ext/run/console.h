#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "colmap_ext/run/interrupt.h"
#include "limn/pipeline/result_cache.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn::colmap_ext {

// What was told of a run, for its report.
struct RunLog {
  struct Stage {
    StageSummary summary;
    double seconds = 0;
    int64_t peak_memory_mb = 0;
  };
  std::vector<Stage> stages;
  std::vector<std::string> warnings;
};

// What the user sees of a run on standard output: progress with the time left (one line that is
// rewritten on a terminal; otherwise a plain line every 10 %, not more than one in 2 seconds), and
// a summary after every stage. SIGINT and SIGTERM end the run (see InterruptWatch), and what is
// kept of it is said.
class Console {
 public:
  // One console at a time. One that does not speak writes nothing.
  explicit Console(int num_threads, bool speaks = true);
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;
  ~Console();

  // For the stages. Refers to this console.
  const RunContext& context() const { return context_; }

  // Lines that begin with "WARNING: " are kept for the log.
  void Say(const std::string& line);
  // Counts in, kept and dropped, seconds since the last summary, peak memory of the program. What
  // the stage found in the cache, what it had to make again and what it could not keep goes before,
  // one line each.
  void Report(const StageSummary& summary);
  // From now on the run keeps its results here.
  void SetCache(std::shared_ptr<const ResultCache> cache);

  const RunLog& log() const { return log_; }

 private:
  using Clock = std::chrono::steady_clock;

  void ReportCache();
  // What an interrupted run leaves behind.
  std::string WhatIsKept() const;
  void ShowProgress(const char* stage, size_t done, size_t total);
  void ClearProgressLine();

  bool speaks_;
  RunContext context_;
  RunLog log_;
  mutable std::mutex cache_mutex_;
  std::shared_ptr<const ResultCache> cache_;
  std::set<std::pair<CachedKind, int>> reported_rounds_;
  bool is_terminal_ = false;
  bool has_progress_line_ = false;
  std::string progress_stage_;
  size_t progress_done_ = 0;
  int progress_tenth_ = 0;
  Clock::time_point progress_start_;
  Clock::time_point last_shown_;
  Clock::time_point stage_start_;
  // Last: its thread asks what is kept.
  InterruptWatch interrupts_;
};

}  // namespace limn::colmap_ext
