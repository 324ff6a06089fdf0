// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

#include <Eigen/Core>

#include "limn/cameras/camera_problem.h"
#include "limn/util/parallel.h"

namespace limn {

using Vector6d = Eigen::Matrix<double, 6, 1>;

// Values of all unknowns.
struct CameraState {
  std::vector<Rigid3d> body_poses;
  std::map<int, Eigen::VectorXd> parameters;
  std::vector<Eigen::Vector3d> landmarks;  // along their ways, px
};

// The normal equations of bodies and parameters: normal * step = -gradient.
struct CameraSystem {
  Eigen::MatrixXd normal;  // upper triangle
  Eigen::VectorXd gradient;
};

// What curves, and landmarks on none, each add to the gradient.
struct CurveScatter {
  Eigen::MatrixXd sum;  // of the squares, upper triangle
  int num_curves = 0;   // that add something
};

// The least squares problem of FitCameras.
class CameraEquations {
 public:
  CameraEquations(const CameraFitInput& input, const RunContext& context,
                  const std::vector<Landmark>& landmarks);

  CameraState Start() const;
  double Cost(const CameraState& state) const;
  // Of landmarks on curves alone.
  double CurveCost(const CameraState& state) const;
  // Without the landmarks, which are eliminated.
  CameraSystem Linearize(const CameraState& state) const;
  // At a minimum.
  CurveScatter Scatter(const CameraState& state) const;
  // The state after a step of bodies and parameters, and the steps of landmarks that go with it.
  CameraState After(const CameraState& state, const Eigen::VectorXd& step) const;

  int size() const { return size_; }
  // Per body its first unknown; -1 = held.
  const std::vector<int>& body_at() const { return body_at_; }
  // Per camera that is adjusted its first unknown.
  const std::map<int, int>& camera_at() const { return camera_at_; }
  // Per unknown, standard deviations of its hold per unit, near where it is held.
  Eigen::VectorXd PerSigma() const;
  // Per unknown, what its hold adds to the diagonal of the normal equations.
  Eigen::VectorXd Holds(const CameraState& state) const;

 private:
  struct Row;
  struct Block;

  int NumParts() const;
  size_t BeginOfPart(size_t part) const;
  template <typename Visit>
  void ForLandmarks(const Visit& visit) const;
  template <typename Counts>
  double LandmarksCost(const CameraState& state, const Counts& counts) const;
  double LandmarkCost(const CameraState& state, const std::vector<Rigid3d>& poses, size_t l) const;
  void FillBlock(const CameraState& state, const std::vector<Rigid3d>& poses, size_t l,
                 Block* block) const;
  static void Eliminate(Block* block);
  static void AddGradient(const Block& block, Eigen::VectorXd* gradient);
  static void AddNormal(const Block& block, Eigen::MatrixXd* normal);
  static void AddProduct(double factor, const Row& a, const Row& b, Eigen::MatrixXd* normal);
  void AddHolds(const CameraState& state, CameraSystem* system) const;
  Vector6d MotionFromGiven(const CameraState& state, size_t body) const;
  // The same in standard deviations.
  Vector6d HeldMotion(const CameraState& state, size_t body) const;
  std::vector<Rigid3d> ViewPoses(const CameraState& state) const;

  const CameraFitInput& input_;
  const RunContext& context_;
  const std::vector<Landmark>& landmarks_;
  int size_ = 0;
  std::vector<int> body_at_;
  std::map<int, int> camera_at_;
  std::vector<Vector6d> per_sigma_;  // per body
};

}  // namespace limn
