// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cameras/camera_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "limn/cameras/camera_equations.h"
#include "limn/cameras/camera_part.h"

namespace limn {
namespace {

constexpr int kMaxIterations = 10;
constexpr int kMaxAttempts = 6;
constexpr int kLandmarkSteps = 4;
constexpr double kStartDamping = 1e-4;
constexpr double kMinDamping = 1e-9;
// Relative decrease of the cost below which a fit has ended.
constexpr double kMinGain = 1e-4;

// Nothing if the equations have no solution.
std::optional<Eigen::VectorXd> StepOf(const CameraSystem& system, double damping) {
  Eigen::MatrixXd normal = system.normal;
  normal.diagonal() *= 1 + damping;
  const Eigen::LLT<Eigen::MatrixXd, Eigen::Upper> factor(normal);
  if (factor.info() != Eigen::Success) return std::nullopt;
  Eigen::VectorXd step = -factor.solve(system.gradient);
  return step.allFinite() ? std::optional(std::move(step)) : std::nullopt;
}

// Of the unknowns of a part.
CameraSystem Restricted(const CameraSystem& system, const Eigen::MatrixXd& steps) {
  const Eigen::MatrixXd product = system.normal.selfadjointView<Eigen::Upper>() * steps;
  return {steps.transpose() * product, steps.transpose() * system.gradient};
}

// Minimizes; the state is that of the least cost that was found.
class Descent {
 public:
  // Begins with the landmarks where the cameras as they are see them.
  explicit Descent(const CameraEquations& equations)
      : equations_(equations), state_(equations.Start()) {
    const Eigen::VectorXd stay = Eigen::VectorXd::Zero(equations.size());
    for (int i = 0; i < kLandmarkSteps; ++i) state_ = equations.After(state_, stay);
    cost_ = equations.Cost(state_);
  }

  // From now on only the part moves, as one.
  void Restrict(const CameraPart& part, const Eigen::Vector3d& middle) {
    part_ = part;
    middle_ = middle;
  }

  // Returns whether the cost decreased so much that another step is worth it.
  bool Improve() {
    CameraSystem system = equations_.Linearize(state_);
    Eigen::MatrixXd steps;
    if (!part_.empty()) {
      steps = StepsOfPart(part_, equations_, state_, middle_);
      system = Restricted(system, steps);
    }
    for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
      const auto step = StepOf(system, damping_);
      has_solution_ |= step.has_value();
      if (step) {
        CameraState next = equations_.After(state_, part_.empty() ? *step : steps * *step);
        const double cost = equations_.Cost(next);
        if (cost < cost_) {
          const bool goes_on = cost_ - cost > kMinGain * cost_;
          state_ = std::move(next);
          cost_ = cost;
          damping_ = std::max(kMinDamping, damping_ / 10);
          return goes_on;
        }
      }
      damping_ *= 10;
    }
    return false;
  }

  const CameraState& state() const { return state_; }
  double cost() const { return cost_; }
  bool has_solution() const { return has_solution_; }

 private:
  const CameraEquations& equations_;
  CameraPart part_;
  Eigen::Vector3d middle_;
  CameraState state_;
  double cost_;
  double damping_ = kStartDamping;
  bool has_solution_ = false;
};

}  // namespace

std::optional<CameraFitResult> FitCameras(const CameraFitInput& input, const RunContext& context,
                                          std::vector<Landmark>* landmarks) {
  const CameraEquations equations(input, context, *landmarks);
  Descent descent(equations);
  const double cost_of_given = descent.cost();
  const double curve_cost_of_given = equations.CurveCost(descent.state());
  CameraFitResult result;
  if (input.part) {
    const auto& [middle, part] = *input.part;
    result.part = part.empty() ? FindPart(equations, descent.state(), middle) : part;
    if (result.part.empty()) return std::nullopt;
    descent.Restrict(result.part, middle);
  }
  for (int i = 0; i < kMaxIterations; ++i) {
    ThrowIfCancelled(context);
    if (!descent.Improve()) break;
  }
  if (!descent.has_solution() || !std::isfinite(descent.cost())) return std::nullopt;
  if (cost_of_given > 0) result.gain = 1 - descent.cost() / cost_of_given;
  if (curve_cost_of_given > 0) {
    result.gain_of_curves = 1 - equations.CurveCost(descent.state()) / curve_cost_of_given;
  }
  if (input.with_covariance) {
    result.covariance = CovarianceOfCameras(equations, descent.state());
  }
  result.body_poses = descent.state().body_poses;
  result.parameters = descent.state().parameters;
  for (size_t l = 0; l < landmarks->size(); ++l) {
    Landmark& landmark = (*landmarks)[l];
    landmark.position += landmark.ways * descent.state().landmarks[l].head(landmark.ways.cols());
  }
  return result;
}

}  // namespace limn
