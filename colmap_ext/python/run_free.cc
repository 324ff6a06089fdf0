#include "colmap_ext/python/run_free.h"

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "colmap_ext/run/interrupt.h"

namespace limn::colmap_ext {
namespace {

namespace py = pybind11;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kWakeEvery(50);
constexpr std::chrono::milliseconds kGrace(1500);

// Work on its thread, and the thread that waits for it.
struct FreeRun {
  RunMonitor monitor;
  std::mutex mutex;
  std::condition_variable ended;
  bool is_over = false;
  std::exception_ptr error;

  void Do(std::function<void(RunMonitor*)> work) {
    try {
      work(&monitor);
    } catch (...) {
      error = std::current_exception();
    }
    work = nullptr;  // what it owns is freed here
    const std::lock_guard lock(mutex);
    is_over = true;
    ended.notify_all();
  }

  bool IsOver() {
    const std::lock_guard lock(mutex);
    return is_over;
  }

  // Whether the work is over. Releases Python's lock.
  bool WaitABit() {
    const py::gil_scoped_release free;
    std::unique_lock lock(mutex);
    return ended.wait_for(lock, kWakeEvery, [this] { return is_over; });
  }
};

// Throws what Python raises.
void SpeakToPython(const py::object& progress, RunMonitor* monitor) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (progress.is_none()) return;
  if (const auto latest = monitor->TakeProgress()) {
    progress(latest->stage, latest->done, latest->total);
  }
}

// Work that goes on to its next check after it was cancelled.
struct LeftRun {
  std::shared_ptr<FreeRun> run;
  std::thread thread;
};

// Under Python's lock.
std::vector<LeftRun>& LeftRuns() {
  static std::vector<LeftRun> runs;
  return runs;
}

void JoinEnded() {
  std::erase_if(LeftRuns(), [](LeftRun& left) {
    if (!left.run->IsOver()) return false;
    left.thread.join();
    return true;
  });
}

}  // namespace

void RunWithoutLock(const py::object& progress, std::function<void(RunMonitor*)> work) {
  JoinEnded();
  const auto run = std::make_shared<FreeRun>();
  std::thread thread([run, work = std::move(work)]() mutable { run->Do(std::move(work)); });
  std::exception_ptr raised;
  Clock::time_point deadline = Clock::time_point::max();
  bool is_over = false;
  while (!is_over && Clock::now() < deadline) {
    is_over = run->WaitABit();
    if (raised) continue;
    try {
      SpeakToPython(progress, &run->monitor);
    } catch (py::error_already_set&) {
      raised = std::current_exception();
      run->monitor.Cancel();
      deadline = Clock::now() + kGrace;
    }
  }
  if (is_over) {
    thread.join();
  } else {
    LeftRuns().push_back({run, std::move(thread)});
  }
  if (raised) std::rethrow_exception(raised);
  if (run->error) std::rethrow_exception(run->error);
}

void JoinLeftWork() {
  for (LeftRun& left : LeftRuns()) {
    while (!left.run->WaitABit()) {
      // Asked once more: without what is freed at the end of a program, which the work uses.
      if (PyErr_CheckSignals() != 0) std::_Exit(kInterruptedExitCode);
    }
    left.thread.join();
  }
  LeftRuns().clear();
}

}  // namespace limn::colmap_ext
