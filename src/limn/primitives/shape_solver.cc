// SPDX-License-Identifier: BSD-3-Clause
#include "limn/primitives/shape_solver.h"

#include "limn/util/quiet_solver.h"

namespace limn {

void SolveShape(ceres::Problem* problem, int max_iterations) {
  ceres::Solver::Options options;
  // Fast; where it fails, the next step is damped more.
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = max_iterations;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  const QuietSolver quiet;
  ceres::Solve(options, problem, &summary);
}

}  // namespace limn
