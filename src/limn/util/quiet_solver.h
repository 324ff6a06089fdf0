// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace limn {

// Keeps Ceres from printing during its lifetime, also in other threads: with its own logging off it
// still tells of numbers that are not finite, by glog and on standard error. Programs that use glog
// have their level back afterwards.
class QuietSolver {
 public:
  QuietSolver();
  ~QuietSolver();
  QuietSolver(const QuietSolver&) = delete;
  QuietSolver& operator=(const QuietSolver&) = delete;
};

}  // namespace limn
