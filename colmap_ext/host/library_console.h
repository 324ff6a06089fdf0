// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>

#include "colmap_ext/host/console.h"

namespace limn::colmap_ext {

// How far a run is.
struct RunProgress {
  std::string stage;
  size_t done = 0;
  size_t total = 0;
};

// Between a run and the thread that waits for it. Thread-safe.
class RunMonitor {
 public:
  // Asks the run to stop: its stages throw Cancelled.
  void Cancel() { cancelled_ = true; }
  const std::atomic<bool>& cancelled() const { return cancelled_; }

  void SetProgress(const char* stage, size_t done, size_t total);
  // The latest, if there is a new one since the last call.
  std::optional<RunProgress> TakeProgress();

 private:
  std::atomic<bool> cancelled_ = false;
  std::mutex mutex_;
  RunProgress latest_;
  bool is_new_ = false;
};

// The console of programs that use Limn as a library: prints nothing and handles no signals. Its
// log has the warnings and stages.
class LibraryConsole : public Console {
 public:
  // The monitor must outlive the console.
  LibraryConsole(int num_threads, RunMonitor* monitor);

  void ShowTable(const std::string&) override {}

 private:
  void ShowLine(const std::string&) override {}
  void ShowStage(const RunLog::Stage&) override {}
};

}  // namespace limn::colmap_ext
