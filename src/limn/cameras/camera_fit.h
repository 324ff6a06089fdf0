// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/cameras/camera_covariance.h"
#include "limn/cameras/camera_problem.h"
#include "limn/geometry/rigid3.h"
#include "limn/util/parallel.h"

namespace limn {

struct CameraFitResult {
  std::vector<Rigid3d> body_poses;
  std::map<int, Eigen::VectorXd> parameters;  // as in the input
  // Share of the cost that the motion of the cameras explains: what is left after that of the
  // landmarks alone, and does not remain.
  double gain = 0;
  // The same of curves alone. Below 0 if points gain what curves lose.
  double gain_of_curves = 0;
  CameraPart part;                             // that moved, if the input asks for one
  std::optional<CameraCovariance> covariance;  // if the input asks for it
};

// Moves bodies, parameters of cameras and landmarks to minimize
//   sum over lines of weight * c^2 log(1 + (d / c)^2),   d: distance of the landmark's image, px,
// with c = robust_px, and holds: 6 log(1 + m^2 / 6) of each body, m the length of its motion from
// where it was given, unknowns in units of 5 px in the images, since some may be lost; squares of
// landmarks from where they are, with a standard deviation of 50 px, and of parameters, with 10 px.
// Levenberg-Marquardt with reweighted least squares; the landmarks are eliminated from the normal
// equations, which are then dense, of 6 unknowns per body. Lines of views that have the landmark
// behind them count as far away. Deterministic for any number of threads. Returns nothing, and
// changes nothing, if there is no solution. Throws Cancelled. Time per step: the squares of the
// numbers of lines of landmarks, and the cube of the number of bodies. Memory: up to 16 times the
// normal equations, or 150 MB; with a part, that of FindPart.
std::optional<CameraFitResult> FitCameras(const CameraFitInput& input, const RunContext& context,
                                          std::vector<Landmark>* landmarks);

}  // namespace limn
