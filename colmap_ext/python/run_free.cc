// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/python/run_free.h"

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

#include "colmap_ext/host/interrupt.h"
#include "limn/files/temporary_path.h"

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
  // Under Python's lock.
  std::thread thread;
  bool is_left = false;       // to end alone
  bool is_forgotten = false;  // its thread is in the parent process

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

// All runs that are waited for or left, and what the interpreter does. Under Python's lock.
struct Interpreter {
  std::vector<std::shared_ptr<FreeRun>> runs;
  std::optional<std::thread::id> ending_thread;  // once it ends
};

Interpreter& ThisInterpreter() {
  // Never destroyed: a process may end while runs continue.
  static Interpreter* const interpreter = new Interpreter;
  return *interpreter;
}

// Raises SystemExit, which ends a thread in silence, if another thread ends the interpreter.
void ThrowAtEnd() {
  const auto& ending = ThisInterpreter().ending_thread;
  if (!ending || *ending == std::this_thread::get_id()) return;
  PyErr_SetNone(PyExc_SystemExit);
  throw py::error_already_set();
}

// Throws what Python raises.
void SpeakToPython(const py::object& progress, RunMonitor* monitor) {
  ThrowAtEnd();
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (progress.is_none()) return;
  if (const auto latest = monitor->TakeProgress()) {
    progress(latest->stage, latest->done, latest->total);
  }
}

// Of the runs that are left.
void JoinEnded() {
  std::erase_if(ThisInterpreter().runs, [](const std::shared_ptr<FreeRun>& run) {
    if (!run->is_left || !run->IsOver()) return false;
    run->thread.join();
    return true;
  });
}

std::shared_ptr<FreeRun> Begin(std::function<void(RunMonitor*)> work) {
  auto& runs = ThisInterpreter().runs;
  runs.reserve(runs.size() + 1);  // nothing may fail once there is a thread
  auto run = std::make_shared<FreeRun>();
  run->thread = std::thread([run, work = std::move(work)]() mutable { run->Do(std::move(work)); });
  runs.push_back(run);
  return run;
}

// Until the work is over, or has been asked to stop for too long. Returns what Python raised.
std::exception_ptr WaitFor(FreeRun* run, const py::object& progress) {
  std::exception_ptr raised;
  Clock::time_point deadline = Clock::time_point::max();
  while (!run->WaitABit() && Clock::now() < deadline) {
    if (raised) continue;
    try {
      SpeakToPython(progress, &run->monitor);
    } catch (...) {
      if (run->is_forgotten) throw;
      raised = std::current_exception();
      run->monitor.Cancel();
      deadline = Clock::now() + kGrace;
    }
    if (run->is_forgotten) throw std::runtime_error("a run does not continue in a forked process");
  }
  return raised;
}

void EndRuns() {
  Interpreter& interpreter = ThisInterpreter();
  interpreter.ending_thread = std::this_thread::get_id();
  for (JoinEnded(); !interpreter.runs.empty(); JoinEnded()) {
    {
      const py::gil_scoped_release free;
      std::this_thread::sleep_for(kWakeEvery);
    }
    if (PyErr_CheckSignals() == 0) continue;
    // Asked once more. What the work uses must not be freed, as at the end of a program.
    AbandonWrites();
    std::_Exit(kInterruptedExitCode);
  }
}

void ForgetRuns() {
  auto& runs = ThisInterpreter().runs;
  for (const auto& run : runs) run->is_forgotten = true;
  // Never freed: their threads are not in this process and cannot be joined.
  new auto(std::exchange(runs, {}));
}

}  // namespace

void RunWithoutLock(const py::object& progress, std::function<void(RunMonitor*)> work) {
  JoinEnded();
  ThrowAtEnd();
  const std::shared_ptr<FreeRun> run = Begin(std::move(work));
  const std::exception_ptr raised = WaitFor(run.get(), progress);
  run->is_left = true;
  JoinEnded();
  if (raised) std::rethrow_exception(raised);
  if (run->error) std::rethrow_exception(run->error);
}

void WatchInterpreter() {
  py::module_::import("atexit").attr("register")(py::cpp_function(EndRuns));
  py::module_::import("os").attr("register_at_fork")(py::arg("after_in_child") =
                                                         py::cpp_function(ForgetRuns));
}

}  // namespace limn::colmap_ext
