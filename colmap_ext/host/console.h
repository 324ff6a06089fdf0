// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "limn/cache/result_cache.h"
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

// Receives the messages, progress and results of a run, and keeps its log. What is shown depends on
// the console: the terminal's (terminal_console.h) prints, that of programs using Limn as a library
// (library_console.h) does not.
class Console {
 public:
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;
  virtual ~Console() = default;

  // The context for the stages. Refers to this console.
  const RunContext& context() const { return context_; }

  // Shows a line. Lines that begin with "WARNING: " are added to the log.
  void Say(const std::string& line);
  // Shows the lines that are the result of a run. Throws IoError if they cannot be written.
  virtual void ShowTable(const std::string& lines) = 0;
  // Shows what the stage reused from the cache, recomputed or could not store, one line each; then
  // its counts of items in, kept and dropped, the seconds since the last summary and the program's
  // peak memory.
  void Report(const StageSummary& summary);
  // Shows the time since the console was made.
  void SayTotalTime();
  // Shows what could not be stored since the last stage, then repeats the warnings of the whole
  // run, which the output of the stages may have scrolled away.
  void RepeatWarnings();
  // Sets the cache whose use is reported from now on.
  void SetCache(std::shared_ptr<const ResultCache> cache);

  const RunLog& log() const { return log_; }

 protected:
  using Clock = std::chrono::steady_clock;

  explicit Console(int num_threads);

  static double SecondsSince(Clock::time_point start);

  RunContext& mutable_context() { return context_; }
  // The cache that was set last, or null. From any thread.
  std::shared_ptr<const ResultCache> cache() const;

 private:
  virtual void ShowLine(const std::string& line) = 0;
  virtual void ShowStage(const RunLog::Stage& stage) = 0;
  void ReportCache();

  RunContext context_;
  RunLog log_;
  mutable std::mutex cache_mutex_;
  std::shared_ptr<const ResultCache> cache_;
  std::set<std::pair<CachedKind, int>> reported_rounds_;
  Clock::time_point start_;
  Clock::time_point stage_start_;
};

// What the console of a command prints.
enum class Printing {
  kOff,     // nothing: of several processes of a run only one prints
  kStages,  // of a stage its name, time and warnings
  kCounts,  // also its memory, and what came in, was kept and dropped
};
// Of --log_level.
Printing PrintingAt(int log_level);

// What to show of a stage.
std::vector<std::string> LinesOf(const RunLog::Stage& stage, Printing printing);

// Makes the console of a command.
using ConsoleMaker = std::function<std::unique_ptr<Console>(int num_threads, Printing printing)>;

}  // namespace limn::colmap_ext
