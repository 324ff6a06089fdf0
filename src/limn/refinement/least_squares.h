#pragma once

#include <ceres/problem.h>

#include "limn/util/parallel.h"

namespace limn {

// Minimize with Ceres: sparse Cholesky factors of the normal matrix, one thread. False, and nothing
// changed, if there is no usable solution. Deterministic. Throws Cancelled.
bool Minimize(int max_iterations, const RunContext& context, ceres::Problem* problem);

}  // namespace limn
