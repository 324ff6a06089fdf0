// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/quiet_solver.h"

#include <mutex>

#include <glog/logging.h>

namespace limn {
namespace {

struct Quiet {
  std::mutex mutex;
  int num_alive = 0;
  int level_before = 0;
};

Quiet& ThisProcess() {
  static Quiet quiet;
  return quiet;
}

}  // namespace

QuietSolver::QuietSolver() {
  Quiet& quiet = ThisProcess();
  const std::lock_guard lock(quiet.mutex);
  if (quiet.num_alive++ > 0) return;
  quiet.level_before = FLAGS_minloglevel;
  FLAGS_minloglevel = google::GLOG_FATAL;
}

QuietSolver::~QuietSolver() {
  Quiet& quiet = ThisProcess();
  const std::lock_guard lock(quiet.mutex);
  if (--quiet.num_alive == 0) FLAGS_minloglevel = quiet.level_before;
}

}  // namespace limn
