// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/terminal_console.h"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <sstream>

#include <unistd.h>

#include "limn/util/errors.h"
#include "limn/util/printable.h"

namespace limn::colmap_ext {
namespace {

constexpr double kSecondsBetweenLines = 2;
constexpr double kSecondsBetweenRewrites = 0.1;
// Before that the estimate of the time left is worth nothing.
constexpr double kSecondsBeforeEstimate = 1;

// Of a terminal.
constexpr const char* kClearLine = "\r\033[K";

// "sketches of 3 of 30 views"
std::string KeptOf(const CacheUse& use) {
  return std::string(use.what) + " of " + WithCommas(use.NumKept()) + " of " +
         WithCommas(use.total) + " " + use.items;
}

}  // namespace

TerminalConsole::TerminalConsole(int num_threads, Printing printing)
    : Console(num_threads),
      printing_(printing),
      is_terminal_(isatty(STDOUT_FILENO) == 1),
      interrupts_([this]() -> std::string {
        if (printing_ == Printing::kOff) return "";
        if (is_terminal_) std::fputs(kClearLine, stdout);
        std::fflush(stdout);
        return WhatIsKept();
      }) {
  mutable_context().progress = [this](const char* stage, size_t done, size_t total) {
    ShowProgress(stage, done, total);
  };
  mutable_context().cancelled = &interrupts_.interrupted();
}

TerminalConsole::~TerminalConsole() { ClearProgressLine(); }

std::string TerminalConsole::WhatIsKept() const {
  const std::shared_ptr<const ResultCache> stored = cache();
  if (!stored) return WhatIsWritten();
  std::string kept;
  for (int kind = 0; kind < kNumCachedKinds; ++kind) {
    const CacheUse use = stored->Use(static_cast<CachedKind>(kind));
    if (use.NumKept() > 0 && use.total > 0) kept += (kept.empty() ? "" : " and ") + KeptOf(use);
  }
  if (kept.empty())
    return "Interrupted: nothing new is kept; run the same command again to start over";
  return "Interrupted: " + kept + " are kept in " + stored->dir() +
         "; run the same command again to continue";
}

void TerminalConsole::ShowProgress(const char* stage, size_t done, size_t total) {
  if (printing_ == Printing::kOff || total == 0) return;
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
  Print(is_terminal_ ? std::string(kClearLine) + line : std::string(line) + "\n");
  has_progress_line_ = is_terminal_;
}

bool TerminalConsole::Print(const std::string& text) {
  if (printing_ == Printing::kOff) return true;
  errno = 0;
  const bool is_printed =
      std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!is_printed && errno == EPIPE) interrupts_.Interrupt();
  return is_printed;
}

void TerminalConsole::PrintLine(const std::string& line) { Print(PrintableLine(line) + "\n"); }

void TerminalConsole::ClearProgressLine() {
  if (has_progress_line_) Print(kClearLine);
  has_progress_line_ = false;
}

void TerminalConsole::ShowLine(const std::string& line) {
  ClearProgressLine();
  PrintLine(line);
}

void TerminalConsole::ShowTable(const std::string& lines) {
  ClearProgressLine();
  std::string table;
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) table += PrintableLine(line) + "\n";
  if (Print(table)) return;
  if (errno == EPIPE) throw Cancelled();
  throw IoError("standard output", "the table could not be written");
}

void TerminalConsole::ShowStage(const RunLog::Stage& stage) {
  ClearProgressLine();
  for (const std::string& line : LinesOf(stage, printing_)) PrintLine(line);
}

std::unique_ptr<Console> MakeTerminalConsole(int num_threads, Printing printing) {
  return std::make_unique<TerminalConsole>(num_threads, printing);
}

}  // namespace limn::colmap_ext
