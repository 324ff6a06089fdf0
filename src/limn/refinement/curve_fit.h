#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/refinement/curve_terms.h"

namespace limn {

// Per control point its covariance, world units squared; empty for points that were not fitted.
using Covariances = std::vector<std::optional<Eigen::Matrix3d>>;

// Moves the control points to minimize
//   sum over pulls of weight / variance * c^2 log(1 + (d / c)^2)
// and the other terms of curve_terms.h, where d is the distance to the tangent line of the edgel,
// stored px, and c = robust_residual_px (pull_cost.h; ALGORITHM.md 16.3). Ceres solves each
// component separately. Fills `covariances`, unless null, with the diagonal blocks of the inverse
// normal matrix at the minimum. Deterministic.
void FitCurves(const FitInput& input, const RefinementOptions& options, const RunContext& context,
               ControlGraph* control, Covariances* covariances);

}  // namespace limn
