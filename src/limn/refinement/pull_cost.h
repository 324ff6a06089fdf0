// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <ceres/cost_function.h>

#include "limn/model/view.h"
#include "limn/support/edgel_residual.h"

namespace limn {

// A line in the image of a view onto which a place in space should project.
struct LinePull {
  const View* view;
  EdgelLine line;
  double scale;  // k below
};

// The data term of the fits of curves (algorithm/refinement.md#data-term).
//
// Distance. A place x, world units, is the weighted sum of control points: (1 - t) a + t b at t on
// the segment from a to b. Its image has the signed distance d from the line, stored px
// (ResidualToEdgel).
//
// Loss. An edgel costs k^2 c^2 log(1 + (d / c)^2) (Cauchy): (k d)^2 as long as |d| is small against
// c = robust_px, and growing ever more slowly beyond. k^2 is the weight of the edgel, 1 / px^2
// (EdgelPull). The residual is the signed root of the loss,
//   r = k c sign(d) sqrt(log(1 + u^2)),   u = d / c,
// so that least squares of r minimizes the sum of the losses. A ceres::LossFunction acts on all
// residuals of a block together, whereas here each of a block has its own. c may be infinite: r = k
// d. Behind the camera d is a large constant, so that moving there never lowers the cost.
//
// Derivatives. dr = k h dd with h = |u| / ((1 + u^2) sqrt(log(1 + u^2))), which goes to 1 with
// u -> 0.
class PullCost : public ceres::CostFunction {
 public:
  // One residual per pull. Parameter blocks: as many points as weights.
  PullCost(std::vector<LinePull> pulls, std::vector<double> weights, double robust_px);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  std::vector<LinePull> pulls_;
  std::vector<double> weights_;  // of the points
  double robust_px_;
};

}  // namespace limn
