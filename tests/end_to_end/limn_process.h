// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "colmap_ext/temp_dir.h"

namespace limn::testing {

// The built `limn` at work, to be signalled while it runs. Killed at the end if it still does.
class LimnProcess {
 public:
  explicit LimnProcess(const std::vector<std::string>& arguments);
  ~LimnProcess();
  LimnProcess(const LimnProcess&) = delete;
  LimnProcess& operator=(const LimnProcess&) = delete;

  pid_t pid() const { return pid_; }
  void Signal(int signal) const;
  // Waits until a condition holds. Fails the test if the process ends before, or after a minute.
  void WaitUntil(const std::function<bool()>& condition) const;

  struct End {
    int exit_code = -1;  // 128 + signal if one ended it
    double seconds = 0;  // since the call of Wait
    std::string out, err;
  };
  End Wait();

 private:
  TempDir dir_;
  pid_t pid_ = -1;
};

}  // namespace limn::testing
