// SPDX-License-Identifier: BSD-3-Clause
#include "limn/support/point_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "limn/geometry/tangent_frame.h"

namespace limn {

PointFit::PointFit(const Eigen::Vector3d& start, const Eigen::Vector3d& tangent, double prior_sigma,
                   double robust_px)
    : start_(start),
      position_(start),
      across_(TangentFrame(tangent)),
      prior_(1 / std::pow(prior_sigma, 2)),
      robust_px_(robust_px) {}

void PointFit::StepTo(std::span<const EdgelTarget> targets) {
  information_.setZero();
  Eigen::Vector2d right = -prior_ * (across_.transpose() * (position_ - start_));
  for (const EdgelTarget& target : targets) {
    const auto residual = ResidualToEdgel(target.view, target.line, position_);
    if (!residual) continue;
    const double robust = std::min(1.0, robust_px_ / std::abs(residual->residual_px));
    const double weight = robust / target.variance;
    const Eigen::Vector2d gradient = across_.transpose() * residual->gradient;
    information_ += weight * gradient * gradient.transpose();
    right -= weight * gradient * residual->residual_px;
  }
  const Eigen::Matrix2d damped = information_ + prior_ * Eigen::Matrix2d::Identity();
  position_ += across_ * damped.inverse() * right;
}

}  // namespace limn
