// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/adapter/log_console.h"

#include <utility>

#include <glog/logging.h>

#include "limn/util/printable.h"

namespace limn::colmap_ext {
namespace {

constexpr double kSecondsBetweenLogs = 2;

}  // namespace

LogConsole::LogConsole(int num_threads, Printing printing, std::function<bool()> is_stopped)
    : Console(num_threads),
      printing_(printing),
      ask_(std::move(is_stopped)),
      last_shown_(Clock::now()) {
  mutable_context().progress = [this](const char* stage, size_t done, size_t total) {
    if (ask_()) is_stopped_ = true;
    ShowProgress(stage, done, total);
  };
  mutable_context().cancelled = &is_stopped_;
}

void LogConsole::ShowLine(const std::string& line) { LOG(INFO) << Printable(line); }

void LogConsole::ShowStage(const RunLog::Stage& stage) {
  for (const std::string& line : LinesOf(stage, printing_)) ShowLine(line);
}

void LogConsole::ShowProgress(const char* stage, size_t done, size_t total) {
  if (total == 0 || SecondsSince(last_shown_) < kSecondsBetweenLogs) return;
  last_shown_ = Clock::now();
  LOG(INFO) << stage << ": " << 100 * done / total << " %";
}

}  // namespace limn::colmap_ext
