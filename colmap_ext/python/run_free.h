// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <pybind11/pybind11.h>

#include "colmap_ext/host/library_console.h"

namespace limn::colmap_ext {

// Runs `work` on a thread of its own without holding the GIL. Meanwhile the calling thread, which
// holds it, wakes twenty times a second, checks for signals (Ctrl-C, in the main thread) and calls
// progress(stage, done, total) with the latest state, unless `progress` is None. If one of these
// raises, or the interpreter exits, which raises SystemExit, the work is asked to stop and the
// exception propagates; work that does not stop within a second and a half is abandoned and its
// result dropped. Otherwise whatever `work` throws propagates. `work` must not touch Python
// objects, and must own what it uses. Throws std::runtime_error in a process that `progress`
// forked.
void RunWithoutLock(const pybind11::object& progress,
                    std::function<void(RunMonitor* monitor)> work);

// The same, with a result.
template <typename Work>
auto RunFree(const pybind11::object& progress, Work work) {
  using Result = decltype(work(static_cast<RunMonitor*>(nullptr)));
  const auto result = std::make_shared<std::optional<Result>>();
  RunWithoutLock(progress, [result, work = std::move(work)](RunMonitor* monitor) {
    result->emplace(work(monitor));
  });
  return std::move(**result);
}

// Call it once in a module with such functions. The interpreter then waits on exit for the runs of
// other threads and for abandoned work; a second Ctrl-C ends the process at once, leaving no
// half-written files. A forked process does not wait for the runs of its parent.
void WatchInterpreter();

}  // namespace limn::colmap_ext
