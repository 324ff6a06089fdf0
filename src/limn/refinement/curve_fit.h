#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/refinement/edgel_matches.h"

namespace limn {

struct CurveFitInput {
  const std::vector<View>& views;
  const std::vector<ImageCurves>& curves;
  const std::vector<LinkMatches>& matches;
  // Per link: nonzero = its inner points are not unknowns, they follow its nodes.
  const std::vector<uint8_t>& frozen;
};

// Per control point the covariance, world units squared; nothing where nothing was fitted.
using Covariances = std::vector<std::optional<Eigen::Matrix3d>>;

// Move the control points to minimize
//   sum over pulls of weight * Cauchy(distance to the tangent line / its sigma)
//   + sum over bends of |change of direction|^2 / (bending_sigma^2 * length)
//   + what holds points along their curve, where nothing else does
// with Ceres, each set of links that hang together for itself. With `covariances`: they are the
// blocks of the inverse normal matrix at the minimum. Deterministic.
void FitCurves(const CurveFitInput& input, const RefinementOptions& options,
               const RunContext& context, ControlGraph* control, Covariances* covariances);

}  // namespace limn
