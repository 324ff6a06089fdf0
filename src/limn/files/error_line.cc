// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/error_line.h"

#include <cstdio>
#include <mutex>

#include <unistd.h>

#include "limn/util/printable.h"

namespace limn {
namespace {

struct ErrorLines {
  std::mutex mutex;
  int descriptor = STDERR_FILENO;
};

ErrorLines& Lines() {
  static ErrorLines lines;
  return lines;
}

}  // namespace

void PrintErrorLine(const std::string& line) {
  const std::lock_guard lock(Lines().mutex);
  dprintf(Lines().descriptor, "%s\n", PrintableLine(line).c_str());
}

void SendErrorLinesTo(int descriptor) {
  const std::lock_guard lock(Lines().mutex);
  Lines().descriptor = descriptor;
}

}  // namespace limn
