// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

#include "colmap_ext/host/console.h"

namespace limn::colmap_ext {

// Writes to LOG(INFO), as COLMAP does, as much of the stages as `printing` says; progress at most
// every two seconds.
class LogConsole : public Console {
 public:
  // `is_stopped` is called at every progress report and may block; the run stops when it returns
  // true.
  LogConsole(int num_threads, Printing printing, std::function<bool()> is_stopped);

  void ShowTable(const std::string& lines) override { ShowLine(lines); }

 private:
  void ShowLine(const std::string& line) override;
  void ShowStage(const RunLog::Stage& stage) override;
  void ShowProgress(const char* stage, size_t done, size_t total);

  Printing printing_;
  std::function<bool()> ask_;
  std::atomic<bool> is_stopped_ = false;
  Clock::time_point last_shown_;
};

}  // namespace limn::colmap_ext
