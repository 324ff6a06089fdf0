#include "colmap_ext/run/console.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string_view>

#include <unistd.h>

#include "limn/util/printable.h"

namespace limn::colmap_ext {
namespace {

constexpr double kSecondsBetweenLines = 2;
constexpr double kSecondsBetweenRewrites = 0.1;
// Before that the estimate of the time left is worth nothing.
constexpr double kSecondsBeforeEstimate = 1;

double SecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// 1234567 -> "1,234,567".
std::string WithCommas(int64_t value) {
  const std::string digits = std::to_string(value);
  std::string text;
  for (size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0 && digits[i - 1] != '-') text += ',';
    text += digits[i];
  }
  return text;
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

std::vector<std::string> LinesOf(const RunLog::Stage& stage) {
  const StageSummary& summary = stage.summary;
  char seconds[40];
  std::snprintf(seconds, sizeof(seconds), ": %.1f s, peak memory ", stage.seconds);
  std::vector<std::string> lines = {summary.stage + seconds + WithCommas(stage.peak_memory_mb) +
                                    " MB"};
  AddTable("in", summary.in, &lines);
  AddTable("kept", summary.kept, &lines);
  AddTable("dropped", summary.dropped, &lines);
  for (const std::string& warning : summary.warnings) lines.push_back("  WARNING: " + warning);
  return lines;
}

// "sketches of 3 of 30 views"
std::string KeptOf(const CacheUse& use) {
  return std::string(use.what) + " of " + WithCommas(use.NumKept()) + " of " +
         WithCommas(use.total) + " " + use.items;
}

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

}  // namespace

Console::Console(int num_threads, bool speaks)
    : speaks_(speaks), is_terminal_(isatty(STDOUT_FILENO) == 1), stage_start_(Clock::now()) {
  interrupts_.emplace([this]() -> std::string {
    if (!speaks_) return "";
    if (is_terminal_) std::printf("\r\033[K");
    std::fflush(stdout);
    return WhatIsKept();
  });
  SetUpContext(num_threads);
  context_.cancelled = &interrupts_->interrupted();
}

Console::Console(int num_threads, ConsoleHost host)
    : host_(std::move(host)), stage_start_(Clock::now()) {
  SetUpContext(num_threads);
  context_.cancelled = &is_stopped_;
}

Console::~Console() { ClearProgressLine(); }

void Console::SetUpContext(int num_threads) {
  context_.num_threads = num_threads;
  context_.progress = [this](const char* stage, size_t done, size_t total) {
    if (host_ && host_->is_stopped()) is_stopped_ = true;
    ShowProgress(stage, done, total);
  };
}

void Console::Print(const std::string& line) const {
  if (host_) {
    host_->say(Printable(line));
  } else if (speaks_) {
    std::printf("%s\n", Printable(line).c_str());
    std::fflush(stdout);
  }
}

void Console::SetCache(std::shared_ptr<const ResultCache> cache) {
  const std::lock_guard lock(cache_mutex_);
  cache_ = std::move(cache);
  reported_rounds_.clear();
}

std::string Console::WhatIsKept() const {
  const std::lock_guard lock(cache_mutex_);
  std::string kept;
  for (int kind = 0; cache_ && kind < kNumCachedKinds; ++kind) {
    const CacheUse use = cache_->Use(static_cast<CachedKind>(kind));
    if (use.NumKept() > 0 && use.total > 0) kept += (kept.empty() ? "" : " and ") + KeptOf(use);
  }
  if (kept.empty())
    return "Interrupted: nothing new is kept; run the same command again to start over";
  return "Interrupted: " + kept + " are kept in " + cache_->dir() +
         "; run the same command again to go on";
}

void Console::ShowProgress(const char* stage, size_t done, size_t total) {
  if (!speaks_ || total == 0) return;
  // Another stage, or the same one again from the start.
  if (progress_stage_ != stage || done < progress_done_) {
    progress_stage_ = stage;
    progress_tenth_ = 0;
    progress_start_ = last_shown_ = Clock::now();
  }
  progress_done_ = done;
  const double seconds = SecondsSince(progress_start_);
  const double share = static_cast<double>(done) / static_cast<double>(total);
  const int tenth = static_cast<int>(10 * share);
  const bool due =
      is_terminal_ ? SecondsSince(last_shown_) >= kSecondsBetweenRewrites
                   : tenth > progress_tenth_ && SecondsSince(last_shown_) >= kSecondsBetweenLines;
  if (!due) return;
  last_shown_ = Clock::now();
  progress_tenth_ = tenth;
  char line[160];
  const int length =
      std::snprintf(line, sizeof(line), "%s: %3.0f %%", stage, std::floor(100 * share));
  if (seconds >= kSecondsBeforeEstimate && done > 0 && done < total) {
    std::snprintf(line + length, sizeof(line) - length, ", about %.0f s left",
                  std::ceil(seconds * (1 - share) / share));
  }
  if (is_terminal_) {
    std::printf("\r\033[K%s", line);
    std::fflush(stdout);
    has_progress_line_ = true;
  } else {
    Print(line);
  }
}

void Console::ClearProgressLine() {
  if (!has_progress_line_) return;
  std::printf("\r\033[K");
  std::fflush(stdout);
  has_progress_line_ = false;
}

void Console::Say(const std::string& line) {
  ClearProgressLine();
  Print(line);
  constexpr std::string_view kWarning = "WARNING: ";
  if (line.starts_with(kWarning)) log_.warnings.push_back(line.substr(kWarning.size()));
}

void Console::RepeatWarnings() {
  if (log_.warnings.empty()) return;
  Say("Warnings of this run (" + WithCommas(std::ssize(log_.warnings)) + "):");
  for (const std::string& warning : log_.warnings) Say("  " + warning);
}

void Console::Report(const StageSummary& summary) {
  ClearProgressLine();
  ReportCache();
  const RunLog::Stage stage = {summary, SecondsSince(stage_start_), PeakMemoryMb()};
  log_.stages.push_back(stage);
  log_.warnings.insert(log_.warnings.end(), summary.warnings.begin(), summary.warnings.end());
  for (const std::string& line : LinesOf(stage)) Print(line);
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
