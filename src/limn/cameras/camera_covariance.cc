// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cameras/camera_covariance.h"

#include <algorithm>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>

namespace limn {
namespace {

// Centers of held bodies that differ by less, relative to the scene, are one.
constexpr double kSameCenter = 1e-6;

// How a body moves if the world is turned, shifted and scaled about its origin: a column each.
Eigen::Matrix<double, 6, 7> MotionWithWorld(const Rigid3d& pose) {
  const Eigen::Matrix3d rotation = pose.rotation.toRotationMatrix();
  Eigen::Matrix<double, 6, 7> motion = Eigen::Matrix<double, 6, 7>::Zero();
  motion.topLeftCorner<3, 3>() = -rotation;
  motion.bottomLeftCorner<3, 3>() = rotation.colwise().cross(pose.translation);
  motion.block<3, 3>(3, 3) = -rotation;
  motion.bottomRightCorner<3, 1>() = pose.translation;
  return motion;
}

// Of all unknowns, for each motion of the world that leaves held bodies where they are.
Eigen::MatrixXd MotionsWithWorld(const CameraEquations& equations, const CameraState& state) {
  Eigen::MatrixXd free = Eigen::MatrixXd::Zero(equations.size(), 7);
  Eigen::MatrixXd held = Eigen::MatrixXd::Zero(6 * state.body_poses.size() + 1, 7);
  for (size_t b = 0; b < state.body_poses.size(); ++b) {
    const int at = equations.body_at()[b];
    if (at >= 0) free.middleRows<6>(at) = MotionWithWorld(state.body_poses[b]);
    if (at < 0) held.middleRows<6>(6 * b) = MotionWithWorld(state.body_poses[b]);
  }
  if (held.isZero(0)) return free;
  Eigen::FullPivLU<Eigen::MatrixXd> factor(held);
  factor.setThreshold(kSameCenter);
  return free * factor.kernel();
}

// Takes from motions of the unknowns the motion of the world that best explains them, bodies
// counted in px.
Eigen::MatrixXd WithoutMotionOfWorld(const CameraEquations& equations, const CameraState& state) {
  Eigen::VectorXd weights = equations.PerSigma();
  const std::map<int, int>& camera_at = equations.camera_at();  // after all bodies
  if (!camera_at.empty()) weights.tail(weights.size() - camera_at.begin()->second).setZero();
  const Eigen::MatrixXd motions = MotionsWithWorld(equations, state);
  const Eigen::MatrixXd explained =
      (weights.asDiagonal() * motions).completeOrthogonalDecomposition().pseudoInverse() *
      weights.asDiagonal();
  return Eigen::MatrixXd::Identity(equations.size(), equations.size()) - motions * explained;
}

}  // namespace

Eigen::MatrixXd CovarianceOfGradient(const CurveScatter& scatter, const Eigen::VectorXd& holds,
                                     const Eigen::LLT<Eigen::MatrixXd, Eigen::Upper>& normal) {
  const auto size = static_cast<double>(scatter.sum.rows());
  const double count = scatter.num_curves;
  const Eigen::MatrixXd sum = scatter.sum.selfadjointView<Eigen::Upper>();
  const double per_unknown = normal.solve(sum).trace() / size;
  const double share_of_curves = count / (count + size);
  const double of_freedoms = count > 0 ? count / (count - std::min(size, count / 2)) : 1;
  Eigen::MatrixXd covariance =
      of_freedoms *
      (share_of_curves * sum + (1 - share_of_curves) * per_unknown * normal.reconstructedMatrix());
  covariance.diagonal() += holds;
  return covariance;
}

std::optional<CameraCovariance> CovarianceOfCameras(const CameraEquations& equations,
                                                    const CameraState& state) {
  const Eigen::LLT<Eigen::MatrixXd, Eigen::Upper> normal(equations.Linearize(state).normal);
  if (equations.size() == 0 || normal.info() != Eigen::Success) return std::nullopt;
  const CurveScatter scatter = equations.Scatter(state);
  const Eigen::MatrixXd project =
      normal.solve(WithoutMotionOfWorld(equations, state).transpose()).transpose();
  const Eigen::MatrixXd of_gradient = CovarianceOfGradient(scatter, equations.Holds(state), normal);
  return CameraCovariance{project * of_gradient * project.transpose(), equations.body_at(),
                          equations.camera_at()};
}

double EvidenceOfOptics(const CameraCovariance& covariance,
                        const std::map<int, Eigen::VectorXd>& motions) {
  double sum = 0;
  Eigen::Index count = 0;
  for (const auto& [camera, motion] : motions) {
    const int at = covariance.camera_at.at(camera);
    const Eigen::MatrixXd own = covariance.matrix.block(at, at, motion.size(), motion.size());
    const auto factor = own.completeOrthogonalDecomposition();
    sum += motion.dot(factor.solve(motion));
    count += factor.rank();
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

}  // namespace limn
