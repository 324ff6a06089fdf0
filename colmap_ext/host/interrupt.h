// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <thread>

namespace limn::colmap_ext {

// The exit code of an interrupted run, as in shells.
constexpr int kInterruptedExitCode = 130;

// Blocks the signals of InterruptWatch during its lifetime. Threads that start meanwhile, in any
// library, inherit this and leave the signals to the InterruptWatch that the process creates later.
class InterruptsBlocked {
 public:
  InterruptsBlocked();
  ~InterruptsBlocked();
  InterruptsBlocked(const InterruptsBlocked&) = delete;
  InterruptsBlocked& operator=(const InterruptsBlocked&) = delete;

 private:
  struct Before;
  std::unique_ptr<Before> before_;
};

// The line printed on interruption by a command that writes all of its results at the end.
std::string WhatIsWritten();

// Ends the run on SIGINT, SIGTERM and SIGHUP (unless that is ignored, as by nohup), and when nobody
// reads its output any more. Stages are asked to stop and have a second to do so; then, or at a
// second signal, the process exits immediately: files are written atomically, and no library call
// (image codecs, solvers) can delay it. Meanwhile writing to a closed pipe fails with EPIPE.
class InterruptWatch {
 public:
  // Handles the signals, also for threads that start later. `last_words` returns the line to print
  // on interruption, or nothing; it is called at most once, from any thread, and no file appears
  // after it. At most one InterruptWatch may exist.
  explicit InterruptWatch(std::function<std::string()> last_words = WhatIsWritten);
  // Prints the last words if the run ends because it was interrupted.
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  // Interrupts the run, once, as a signal does: nobody reads its output any more.
  void Interrupt();

  // For RunContext.
  const std::atomic<bool>& interrupted() const { return interrupted_; }

 private:
  void Watch();
  void SayLastWords();

  std::function<std::string()> last_words_;
  std::atomic<bool> interrupted_ = false;
  std::atomic<bool> over_ = false;
  std::atomic<bool> said_ = false;
  std::atomic<bool> is_sent_ = false;
  int exceptions_before_;
  std::thread thread_;
};

}  // namespace limn::colmap_ext
