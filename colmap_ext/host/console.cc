// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/console.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string_view>

#include "limn/util/printable.h"
#include "limn/util/return_memory.h"

namespace limn::colmap_ext {
namespace {

// "3 made of other input, 1 damaged (file: reason)"
std::string WhyMadeAgain(const CacheUse& use) {
  std::string why;
  if (use.outdated > 0) {
    why = WithCommas(use.outdated) +
          " made with other options, images or cameras, or by another version of limn";
  }
  if (use.damaged > 0) {
    if (!why.empty()) why += ", ";
    why += WithCommas(use.damaged) + " damaged (" + use.damage + ")";
  }
  return why;
}

// Peak resident memory of this process, MB; 0 where the system does not tell.
int64_t PeakMemoryMb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with("VmHWM:")) continue;
    int64_t kilobytes = 0;
    std::istringstream(line.substr(6)) >> kilobytes;
    return kilobytes / 1024;
  }
  return 0;
}

void AddTable(const char* heading, const StageSummary::Counts& counts,
              std::vector<std::string>* lines) {
  const char* label = heading;
  for (const auto& [reason, count] : counts) {
    char columns[60];
    std::snprintf(columns, sizeof(columns), "  %-8s %12s  ", label, WithCommas(count).c_str());
    lines->push_back(columns + reason);
    label = "";
  }
}

}  // namespace

Printing PrintingAt(int log_level) { return log_level < 2 ? Printing::kStages : Printing::kCounts; }

std::vector<std::string> LinesOf(const RunLog::Stage& stage, Printing printing) {
  const StageSummary& summary = stage.summary;
  char seconds[40];
  std::snprintf(seconds, sizeof(seconds), ": %.1f s", stage.seconds);
  std::vector<std::string> lines = {summary.stage + seconds};
  if (printing == Printing::kCounts) {
    lines.front() += ", peak memory " + WithCommas(stage.peak_memory_mb) + " MB";
    AddTable("in", summary.in, &lines);
    AddTable("kept", summary.kept, &lines);
    AddTable("dropped", summary.dropped, &lines);
  }
  for (const std::string& warning : summary.warnings) lines.push_back("  WARNING: " + warning);
  return lines;
}

Console::Console(int num_threads) : start_(Clock::now()), stage_start_(start_) {
  context_.num_threads = num_threads;
}

double Console::SecondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void Console::SetCache(std::shared_ptr<const ResultCache> cache) {
  const std::lock_guard lock(cache_mutex_);
  cache_ = std::move(cache);
  reported_rounds_.clear();
}

std::shared_ptr<const ResultCache> Console::cache() const {
  const std::lock_guard lock(cache_mutex_);
  return cache_;
}

void Console::Say(const std::string& line) {
  ShowLine(line);
  constexpr std::string_view kWarning = "WARNING: ";
  if (line.starts_with(kWarning)) log_.warnings.push_back(line.substr(kWarning.size()));
}

void Console::SayTotalTime() {
  const auto seconds = static_cast<int64_t>(std::lround(SecondsSince(start_)));
  std::string text = std::to_string(seconds % 60) + " s";
  if (seconds >= 60) text = std::to_string(seconds / 60) + " min " + text;
  Say("Total time: " + text);
}

void Console::RepeatWarnings() {
  ReportCache();
  if (log_.warnings.empty()) return;
  Say("Warnings of this run (" + WithCommas(std::ssize(log_.warnings)) + "):");
  for (const std::string& warning : log_.warnings) Say("  " + warning);
}

void Console::Report(const StageSummary& summary) {
  ReturnFreedMemory();
  ReportCache();
  const RunLog::Stage stage = {summary, SecondsSince(stage_start_), PeakMemoryMb()};
  log_.stages.push_back(stage);
  log_.warnings.insert(log_.warnings.end(), summary.warnings.begin(), summary.warnings.end());
  ShowStage(stage);
  stage_start_ = Clock::now();
}

void Console::ReportCache() {
  for (int k = 0; cache_ && k < kNumCachedKinds; ++k) {
    const CacheUse use = cache_->Use(static_cast<CachedKind>(k));
    if (use.reused + use.outdated + use.damaged + use.not_stored == 0) continue;
    if (!use.IsComplete()) continue;
    if (!reported_rounds_.insert({static_cast<CachedKind>(k), use.round}).second) continue;
    const std::string of = std::string(use.what) + " of ";
    if (use.reused > 0) {
      Say(of + WithCommas(use.reused) + " " + use.items + " were taken from the cache");
    }
    if (use.outdated + use.damaged > 0) {
      Say(of + WithCommas(use.outdated + use.damaged) + " " + use.items +
          " in the cache could not be used and were made again: " + WhyMadeAgain(use));
    }
    if (use.not_stored > 0) {
      Say("WARNING: " + of + WithCommas(use.not_stored) + " " + use.items +
          " are not kept for another run: " + use.write_error);
    }
  }
}

}  // namespace limn::colmap_ext
