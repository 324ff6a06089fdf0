// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/pull_cost.h"

#include <cmath>

namespace limn {
namespace {

// The signed root of the Cauchy loss, and its derivative.
struct Root {
  double value;
  double slope;
};

Root RootOfLoss(double distance_px, double robust_px) {
  const double relative = distance_px / robust_px;
  if (std::abs(relative) < 1e-4) return {distance_px, 1};
  const double root = std::sqrt(std::log1p(relative * relative));
  return {std::copysign(robust_px * root, relative),
          std::abs(relative) / ((1 + relative * relative) * root)};
}

}  // namespace

PullCost::PullCost(std::vector<LinePull> pulls, std::vector<double> weights, double robust_px)
    : pulls_(std::move(pulls)), weights_(std::move(weights)), robust_px_(robust_px) {
  set_num_residuals(static_cast<int>(pulls_.size()));
  mutable_parameter_block_sizes()->assign(weights_.size(), 3);
}

bool PullCost::Evaluate(double const* const* parameters, double* residuals,
                        double** jacobians) const {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  for (size_t k = 0; k < weights_.size(); ++k) {
    place += weights_[k] * Eigen::Map<const Eigen::Vector3d>(parameters[k]);
  }
  for (size_t i = 0; i < pulls_.size(); ++i) {
    const auto& [view, line, scale] = pulls_[i];
    const EdgelResidual distance =
        ResidualToEdgel(*view, line, place).value_or(EdgelResidual{kBehindCameraPx});
    const Root root = RootOfLoss(distance.residual_px, robust_px_);
    residuals[i] = scale * root.value;
    if (!jacobians) continue;
    const Eigen::Vector3d gradient = scale * root.slope * distance.gradient;
    for (size_t k = 0; k < weights_.size(); ++k) {
      if (jacobians[k]) Eigen::Map<Eigen::Vector3d>(jacobians[k] + 3 * i) = weights_[k] * gradient;
    }
  }
  return true;
}

}  // namespace limn
