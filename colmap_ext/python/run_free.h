#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <pybind11/pybind11.h>

#include "colmap_ext/host/library_console.h"

namespace limn::colmap_ext {

// Runs `work` on a thread of its own without Python's lock. Meanwhile the calling thread, which
// holds the lock, wakes twenty times a second, looks for signals (Ctrl-C, in the main thread) and
// calls progress(stage, done, total) with the latest state, unless `progress` is None. If one of
// these raises, or the interpreter ends, which raises SystemExit, the work is asked to stop, and
// the exception propagates: a work that does not stop within a second and a half is left to end
// alone, with its result dropped. Otherwise what `work` throws propagates. `work` must not touch
// Python, and must own what it uses. Throws std::runtime_error in a process that `progress` forked.
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

// To be called once by a module with such functions. The end of the interpreter then waits for all
// runs of other threads and for work that was left to end alone; a second Ctrl-C ends the process
// at once, without files that are half written. A forked process does not wait for the runs of its
// parent.
void WatchInterpreter();

}  // namespace limn::colmap_ext
