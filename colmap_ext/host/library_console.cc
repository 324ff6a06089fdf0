// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/library_console.h"

namespace limn::colmap_ext {

void RunMonitor::SetProgress(const char* stage, size_t done, size_t total) {
  const std::lock_guard lock(mutex_);
  latest_.stage = stage;
  latest_.done = done;
  latest_.total = total;
  is_new_ = true;
}

std::optional<RunProgress> RunMonitor::TakeProgress() {
  const std::lock_guard lock(mutex_);
  if (!is_new_) return std::nullopt;
  is_new_ = false;
  return latest_;
}

LibraryConsole::LibraryConsole(int num_threads, RunMonitor* monitor) : Console(num_threads) {
  mutable_context().progress = [monitor](const char* stage, size_t done, size_t total) {
    monitor->SetProgress(stage, done, total);
  };
  mutable_context().cancelled = &monitor->cancelled();
}

}  // namespace limn::colmap_ext
