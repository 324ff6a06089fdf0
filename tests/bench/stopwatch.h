// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <ctime>

namespace limn::bench {

struct Times {
  double seconds = 0;      // wall clock
  double cpu_seconds = 0;  // of all threads of the program

  friend Times operator+(const Times& a, const Times& b) {
    return {a.seconds + b.seconds, a.cpu_seconds + b.cpu_seconds};
  }
};

// Runs from its construction on.
class Stopwatch {
 public:
  Times Elapsed() const {
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(),
            static_cast<double>(std::clock() - cpu_start_) / CLOCKS_PER_SEC};
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::clock_t cpu_start_ = std::clock();
};

}  // namespace limn::bench
