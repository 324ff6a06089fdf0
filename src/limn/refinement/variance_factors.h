// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/refinement/curve_fit.h"

namespace limn {

// Per control point the factor, at least 1, by which its variance exceeds that of the inverse
// normal matrix, which trusts edgels and smoothing equally everywhere
// (algorithm/refinement.md#covariances). The product of
//   reduced chi-square of the views around the point: an edge has its own offset in every image
//   (light, blur, another edge beside it), so that the views are the independent samples, each with
//   the mean residual of its edgels within 6 px; two degrees of freedom go to the curve, and a
//   prior of four views says that the weights are right; and 1 + the largest squared change of
//   direction within 6 px over its variance in the smoothing: where smoothing and edgels pull
//   against each other, neither can be trusted.
// A node has the largest factor of its links. Time: pulls.
std::vector<double> VarianceFactors(const RefinementOptions& options, const ControlGraph& control);

}  // namespace limn
