// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/quiet_decoders.h"

#include <atomic>
#include <mutex>

#include <fcntl.h>
#include <unistd.h>

#include "limn/files/error_line.h"

namespace limn {
namespace {

std::atomic<bool> lines_are_hidden = false;

struct StandardError {
  std::mutex mutex;
  int num_quiet = 0;
  int kept = -1;  // a copy of the descriptor while num_quiet > 0; -1 if there is none
};

StandardError& State() {
  static StandardError state;
  return state;
}

}  // namespace

void HideLinesOfDecoders() { lines_are_hidden = true; }

QuietDecoders::QuietDecoders() : is_quiet_(lines_are_hidden) {
  if (!is_quiet_) return;
  StandardError& state = State();
  const std::lock_guard lock(state.mutex);
  if (state.num_quiet++ > 0) return;
  const int null_device = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (null_device < 0) return;
  state.kept = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  if (state.kept >= 0) {
    SendErrorLinesTo(state.kept);
    dup2(null_device, STDERR_FILENO);
  }
  close(null_device);
}

QuietDecoders::~QuietDecoders() {
  if (!is_quiet_) return;
  StandardError& state = State();
  const std::lock_guard lock(state.mutex);
  if (--state.num_quiet > 0 || state.kept < 0) return;
  dup2(state.kept, STDERR_FILENO);
  SendErrorLinesTo(STDERR_FILENO);
  close(state.kept);
  state.kept = -1;
}

}  // namespace limn
