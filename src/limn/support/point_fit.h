// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include <Eigen/Core>

#include "limn/model/view.h"
#include "limn/support/edgel_residual.h"

namespace limn {

// An edgel that a point of a curve is drawn to.
struct EdgelTarget {
  const View& view;
  EdgelLine line;
  double variance = 0;  // of the residual, px^2
};

// A point of a curve that moves in the plane across it, towards edgels, by robust Gauss-Newton
// steps (algorithm/drawing.md#position).
class PointFit {
 public:
  // `prior_sigma`, world units, holds the point where it is. Residuals of more than `robust_px`
  // count linearly.
  PointFit(const Eigen::Vector3d& start, const Eigen::Vector3d& tangent, double prior_sigma,
           double robust_px);

  void StepTo(std::span<const EdgelTarget> targets);

  const Eigen::Vector3d& position() const { return position_; }

  // Of the targets of the last step, without the prior; across the curve.
  Eigen::Matrix3d Information() const { return across_ * information_ * across_.transpose(); }

 private:
  Eigen::Vector3d start_;
  Eigen::Vector3d position_;
  Eigen::Matrix<double, 3, 2> across_;
  double prior_;
  double robust_px_;
  Eigen::Matrix2d information_ = Eigen::Matrix2d::Zero();
};

}  // namespace limn
