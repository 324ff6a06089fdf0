// SPDX-License-Identifier: BSD-3-Clause
// Preloaded, this makes all file systems such as have no locks.
#include <cerrno>

extern "C" int flock(int, int) {
  errno = ENOLCK;
  return -1;
}
