#pragma once

#include <ceres/problem.h>

#include "limn/util/parallel.h"

namespace limn {

// Minimizes with Ceres by sparse Cholesky factorization of the normal matrix, on one thread.
// Returns false, and changes nothing, if there is no usable solution. Deterministic. Throws
// Cancelled.
bool Minimize(int max_iterations, const RunContext& context, ceres::Problem* problem);

}  // namespace limn
