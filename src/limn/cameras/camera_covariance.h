// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "limn/cameras/camera_equations.h"

namespace limn {

// Of motions of bodies that are not held (a turn about their axes, rad, and a shift, world units;
// one after the other) and of the parameters of cameras, with all else unknown.
struct CameraCovariance {
  Eigen::MatrixXd matrix;
  std::vector<int> body_at;      // per body its first row; -1: held
  std::map<int, int> camera_at;  // per camera that is adjusted
};

// At a minimum. Edgels of a curve err together, hence the covariance of an M-estimator with curves
// as the independent samples, H^-1 (sum g g') H^-1 with g the gradients of curves (Huber 1967;
// Liang and Zeger 1986). Place, orientation and scale of the world, which images do not determine,
// are as close as can be to where they are. Nothing without unknowns, or if the equations have no
// solution. Time: the cube of the number of unknowns, and its square times the number of curves.
std::optional<CameraCovariance> CovarianceOfCameras(const CameraEquations& equations,
                                                    const CameraState& state);

// The covariance of the gradient at a minimum. Curves fit better than they err, by as many freedoms
// as there are unknowns, and few of them do not tell about all directions: these are those of the
// normal equations then. Holds (CameraEquations::Holds) are samples of their own.
Eigen::MatrixXd CovarianceOfGradient(const CurveScatter& scatter, const Eigen::VectorXd& holds,
                                     const Eigen::LLT<Eigen::MatrixXd, Eigen::Upper>& normal);

// Mean square of the motions of parameters in terms of their standard deviations, each camera by
// itself, without parameters whose variance is 0 (Wald 1943): 1 if they move by chance alone.
double EvidenceOfOptics(const CameraCovariance& covariance,
                        const std::map<int, Eigen::VectorXd>& motions);

}  // namespace limn
