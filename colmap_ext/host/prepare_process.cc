// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/prepare_process.h"

#include <csignal>
#include <initializer_list>

#include <fcntl.h>
#include <unistd.h>

namespace limn::colmap_ext {
namespace {

// A file opened later must not take the place of a closed standard stream: what is printed would
// get into it.
void OpenStandardStreams() {
  for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // The lowest number that is free is this one.
    if (fcntl(file, F_GETFD) < 0) (void)!open("/dev/null", O_RDWR);
  }
}

}  // namespace

void PrepareProcess() {
  OpenStandardStreams();
  // A file beyond the limit on sizes is then a failed write, with a line that names it.
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace limn::colmap_ext
