#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "colmap_ext/run/interrupt.h"
#include "limn/pipeline/result_cache.h"
#include "limn/util/parallel.h"
#include "limn/util/stage_summary.h"

namespace limn::colmap_ext {

// The stages and warnings of a run, for its report.
struct RunLog {
  struct Stage {
    StageSummary summary;
    double seconds = 0;
    int64_t peak_memory_mb = 0;
  };
  std::vector<Stage> stages;
  std::vector<std::string> warnings;
};

// A program of others that a run is a part of.
struct ConsoleHost {
  // Takes a line for the user, from any thread, one at a time.
  std::function<void(const std::string& line)> say;
  // Asked at every report of progress: whether the run is to stop. May block.
  std::function<bool()> is_stopped;
};

// Prints a run on standard output: progress with the remaining time (one line that is rewritten on
// a terminal; otherwise a plain line every 10 %, at most one in 2 seconds), and a summary after
// every stage. SIGINT and SIGTERM end the run (see InterruptWatch) with a line that says what is
// kept.
class Console {
 public:
  // At most one console may exist at a time. If `speaks` is false it prints nothing.
  explicit Console(int num_threads, bool speaks = true);
  // Speaks to a host, and leaves standard output and signals alone.
  Console(int num_threads, ConsoleHost host);
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;
  ~Console();

  // The context for the stages. Refers to this console.
  const RunContext& context() const { return context_; }

  // Prints a line, without the control characters in it. Lines that begin with "WARNING: " are
  // added to the log.
  void Say(const std::string& line);
  // Prints what the stage reused from the cache, recomputed and could not store, one line each;
  // then the counts in, kept and dropped, the seconds since the last summary and the peak memory of
  // the program.
  void Report(const StageSummary& summary);
  // Prints the warnings of the whole run again, if there are any: stages hide them.
  void RepeatWarnings();
  // The cache that results are stored in from now on.
  void SetCache(std::shared_ptr<const ResultCache> cache);

  const RunLog& log() const { return log_; }

 private:
  using Clock = std::chrono::steady_clock;

  void SetUpContext(int num_threads);
  void Print(const std::string& line) const;
  void ReportCache();
  // The line that says what an interrupted run leaves behind.
  std::string WhatIsKept() const;
  void ShowProgress(const char* stage, size_t done, size_t total);
  void ClearProgressLine();

  bool speaks_ = true;
  std::optional<ConsoleHost> host_;
  std::atomic<bool> is_stopped_ = false;  // by the host
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
  // Last: its thread asks what is kept. Nothing with a host.
  std::optional<InterruptWatch> interrupts_;
};

}  // namespace limn::colmap_ext
