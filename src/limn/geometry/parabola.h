// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include <Eigen/Core>

namespace limn {

// A curve in space, quadratic in its arc length.
struct Parabola {
  Eigen::Vector3d start = Eigen::Vector3d::Zero();  // at arc 0
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();  // there
  Eigen::Vector3d bend = Eigen::Vector3d::Zero();   // half the change of slope per arc

  Eigen::Vector3d At(double arc) const { return start + arc * (slope + arc * bend); }
  Eigen::Vector3d SlopeAt(double arc) const { return slope + 2 * arc * bend; }
};

// The least-squares parabola through at least three points at different arc lengths. A prior of
// weight `bend_weight`, the square of the ratio of the points' noise to the usual size of `bend`,
// draws `bend` to zero; with it two points are enough. Linear time.
Parabola FitParabola(std::span<const Eigen::Vector3d> points, std::span<const double> arcs,
                     double bend_weight = 0);

}  // namespace limn
