#pragma once

#include <atomic>
#include <csignal>
#include <functional>
#include <string>
#include <thread>

namespace limn::colmap_ext {

// The exit code of a run that was interrupted, as shells have it.
constexpr int kInterruptedExitCode = 130;

// While it lives SIGINT and SIGTERM wait. Threads that begin then never take them: they are left to
// the InterruptWatch that this process will have, whatever library the threads belong to.
class InterruptsBlocked {
 public:
  InterruptsBlocked();
  ~InterruptsBlocked();
  InterruptsBlocked(const InterruptsBlocked&) = delete;
  InterruptsBlocked& operator=(const InterruptsBlocked&) = delete;

 private:
  sigset_t before_;
};

// Turns SIGINT and SIGTERM into the end of a run. Stages are asked to stop and have a second for
// it; then, or at a second signal, the process ends where it is: files appear whole or not at all
// whenever that happens, and no library that is called (image codecs, solvers) can delay it.
class InterruptWatch {
 public:
  // Takes over both signals, for threads that begin from now on too. `last_words` is what the run
  // says when it was interrupted, a line or nothing; it is called once at most, from any thread.
  // One at a time.
  explicit InterruptWatch(std::function<std::string()> last_words);
  // If the run is being left because it was interrupted, says the last words.
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  // For RunContext.
  const std::atomic<bool>& interrupted() const { return interrupted_; }

 private:
  void Watch();
  void SayLastWords();

  std::function<std::string()> last_words_;
  std::atomic<bool> interrupted_ = false;
  std::atomic<bool> over_ = false;
  std::atomic<bool> said_ = false;
  int exceptions_before_;
  std::thread thread_;
};

}  // namespace limn::colmap_ext
