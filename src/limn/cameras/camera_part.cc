// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cameras/camera_part.h"

#include <algorithm>
#include <utility>

#include <Eigen/Cholesky>

namespace limn {
namespace {

constexpr size_t kMinBodies = 5;
// In a part, and out of it.
constexpr size_t kMinInPart = 2;
constexpr size_t kNumStarts = 16;
// Relative; keeps ways to move a part that the curves do not see from counting.
constexpr double kDamping = 1e-3;
// An exchange of a body that gains less, relative, ends the climb.
constexpr double kLeastStep = 1e-3;

using PartVector = Eigen::Matrix<double, kPartUnknowns, 1>;
using PartMatrix = Eigen::Matrix<double, kPartUnknowns, kPartUnknowns>;
using BodySteps = Eigen::Matrix<double, 6, kPartUnknowns>;

Eigen::Matrix3d CrossMatrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d cross;
  cross << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return cross;
}

// Of a body that goes along.
BodySteps StepsOfBody(const Rigid3d& pose, const Eigen::Vector3d& middle) {
  const Eigen::Matrix3d rotation = pose.rotation.toRotationMatrix();
  const Eigen::Vector3d arm = -(rotation.transpose() * pose.translation) - middle;
  BodySteps steps;
  steps << -rotation, Eigen::Matrix3d::Zero(), Eigen::Vector3d::Zero(), rotation * CrossMatrix(arm),
      -rotation, -(rotation * arm);
  return steps;
}

// What the cost would lose.
double DecreaseBy(PartMatrix normal, const PartVector& gradient) {
  normal.diagonal() *= 1 + kDamping;
  const Eigen::LLT<PartMatrix> factor(normal);
  return factor.info() == Eigen::Success ? gradient.dot(factor.solve(gradient)) : 0;
}

// Among the bodies that are free.
class PartSearch {
 public:
  PartSearch(const CameraEquations& equations, const CameraState& state,
             const Eigen::Vector3d& middle) {
    std::vector<BodySteps> steps;
    std::vector<int> at;
    for (size_t b = 0; b < equations.body_at().size(); ++b) {
      if (equations.body_at()[b] < 0) {
        ++num_held_;
        continue;
      }
      at.push_back(equations.body_at()[b]);
      steps.push_back(StepsOfBody(state.body_poses[b], middle));
    }
    const CameraSystem system = equations.Linearize(state);
    const size_t n = at.size();
    normal_.resize(n, std::vector<PartMatrix>(n));
    for (size_t i = 0; i < n; ++i) {
      gradient_.push_back(steps[i].transpose() * system.gradient.segment<6>(at[i]));
      for (size_t j = i; j < n; ++j) {
        Eigen::Matrix<double, 6, 6> block = system.normal.block<6, 6>(at[i], at[j]);
        if (i == j) block = Eigen::Matrix<double, 6, 6>(block.selfadjointView<Eigen::Upper>());
        normal_[i][j] = steps[i].transpose() * block * steps[j];
        if (i != j) normal_[j][i] = normal_[i][j].transpose();
      }
    }
  }

  size_t NumBodies() const { return gradient_.size(); }
  size_t NumHeld() const { return num_held_; }

  // Returns the decrease in the end.
  double Climb(CameraPart* part) {
    Take(*part);
    double decrease = DecreaseBy(normal_sum_, gradient_sum_);
    for (size_t i = 0; i < 2 * NumBodies(); ++i) {
      const auto [body, next] = BestExchange(*part);
      if (!(next > (1 + kLeastStep) * decrease)) break;
      Exchange(body, part);
      decrease = next;
    }
    return decrease;
  }

 private:
  void Take(const CameraPart& part) {
    coupling_.assign(NumBodies(), PartMatrix::Zero());
    normal_sum_.setZero();
    gradient_sum_.setZero();
    CameraPart taken(NumBodies(), 0);
    for (size_t b = 0; b < NumBodies(); ++b) {
      if (part[b]) Exchange(b, &taken);
    }
  }

  void Exchange(size_t body, CameraPart* part) {
    const double sign = (*part)[body] ? -1 : 1;
    normal_sum_ += WithExchanged(body, sign);
    gradient_sum_ += sign * gradient_[body];
    for (size_t b = 0; b < NumBodies(); ++b) coupling_[b] += sign * normal_[b][body];
    (*part)[body] ^= 1;
  }

  // What is added. The coupling of a body that leaves has its own block.
  PartMatrix WithExchanged(size_t body, double sign) const {
    return sign * (coupling_[body] + coupling_[body].transpose()) + normal_[body][body];
  }

  // The body that joins or leaves, and the decrease then.
  std::pair<size_t, double> BestExchange(const CameraPart& part) const {
    std::pair<size_t, double> best = {0, 0};
    const auto num_inside = static_cast<size_t>(std::ranges::count(part, 1));
    const size_t num_outside = num_held_ + NumBodies() - num_inside;
    for (size_t b = 0; b < NumBodies(); ++b) {
      const bool leaves = part[b] != 0;
      if ((leaves ? num_inside : num_outside) <= kMinInPart) continue;
      const double sign = leaves ? -1 : 1;
      const double decrease =
          DecreaseBy(normal_sum_ + WithExchanged(b, sign), gradient_sum_ + sign * gradient_[b]);
      if (decrease > best.second) best = {b, decrease};
    }
    return best;
  }

  size_t num_held_ = 0;
  std::vector<PartVector> gradient_;             // per body
  std::vector<std::vector<PartMatrix>> normal_;  // per two bodies
  // Of the part as it is now; the coupling per body.
  std::vector<PartMatrix> coupling_;
  PartMatrix normal_sum_;
  PartVector gradient_sum_;
};

// Those that follow one another up to some place, as merged models do, and every second, as those
// of two cameras do.
std::vector<CameraPart> Starts(size_t num_bodies, size_t num_held) {
  std::vector<CameraPart> starts;
  for (size_t k = 1; k <= kNumStarts; ++k) {
    const size_t end = k * num_bodies / kNumStarts;
    if (end == (k - 1) * num_bodies / kNumStarts) continue;
    if (end < kMinInPart || num_held + num_bodies - end < kMinInPart) continue;
    CameraPart& start = starts.emplace_back(num_bodies, 0);
    std::fill_n(start.begin(), end, 1);
  }
  CameraPart& seconds = starts.emplace_back(num_bodies, 0);
  for (size_t b = 1; b < num_bodies; b += 2) seconds[b] = 1;
  return starts;
}

}  // namespace

Eigen::MatrixXd StepsOfPart(const CameraPart& part, const CameraEquations& equations,
                            const CameraState& state, const Eigen::Vector3d& middle) {
  Eigen::MatrixXd steps = Eigen::MatrixXd::Zero(equations.size(), kPartUnknowns);
  for (size_t b = 0; b < part.size(); ++b) {
    const int at = equations.body_at()[b];
    if (part[b] && at >= 0) steps.middleRows<6>(at) = StepsOfBody(state.body_poses[b], middle);
  }
  return steps;
}

CameraPart FindPart(const CameraEquations& equations, const CameraState& state,
                    const Eigen::Vector3d& middle) {
  PartSearch search(equations, state, middle);
  if (search.NumBodies() < kMinBodies) return {};
  CameraPart best;
  double most = 0;
  for (CameraPart& part : Starts(search.NumBodies(), search.NumHeld())) {
    const double decrease = search.Climb(&part);
    if (!(decrease > most)) continue;
    most = decrease;
    best = std::move(part);
  }
  if (best.empty()) return {};
  CameraPart of_all;
  for (auto free = best.begin(); const int at : equations.body_at()) {
    of_all.push_back(at >= 0 ? *free++ : 0);
  }
  return of_all;
}

}  // namespace limn
