// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/continuation.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace limn {
namespace {

using Eigen::Vector2d;
using Terms = Eigen::Matrix<double, 5, 1>;

constexpr double kReachPx = 30;
// The parabola is that of this length on either side.
constexpr double kGeometryReachPx = 10;
// What costs 1: an offset and a turn at the step, a distance from the parabola (RMS), a ratio of
// strengths, a difference of colors.
constexpr double kOffsetPx = 0.7;
constexpr double kTurnRad = 0.2;
constexpr double kDistancePx = 0.4;
constexpr double kLogStrength = 0.7;
constexpr double kColorLevels = 30;
constexpr double kMaxLookCost = 4;

// A parabola in the frame at the step, except for an offset and a turn at it: y = c0 + c1 x + c2
// x^2 (+ c3 + c4 x ahead of the step).
class BrokenParabola {
 public:
  void Add(double x, double y, bool ahead) {
    Terms row;
    row << 1, x, x * x, ahead ? 1 : 0, ahead ? x : 0;
    matrix_ += row * row.transpose();
    vector_ += y * row;
    squares_ += y * y;
    ++count_;
  }

  double Cost() const {
    const Terms fit = matrix_.ldlt().solve(vector_);
    const double squares = std::max(0.0, squares_ - fit.dot(vector_)) / count_;
    return std::pow(fit[3] / kOffsetPx, 2) + std::pow(fit[4] / kTurnRad, 2) +
           squares / (kDistancePx * kDistancePx);
  }

 private:
  // Weak priors keep short arms in bounds.
  Eigen::Matrix<double, 5, 5> matrix_ = Terms(0, 0.1, 10, 0.1, 1).asDiagonal();
  Terms vector_ = Terms::Zero();
  double squares_ = 0;
  int count_ = 0;
};

}  // namespace

Continuation::Arm Continuation::Follow(EdgelId start,
                                       const std::vector<EdgelId>& successors) const {
  Arm arm;
  double length = 0;
  for (EdgelId e = start; e != kInvalidEdgel && (arm.ids.empty() || e != start);) {
    arm.ids.push_back(e);
    arm.at_px.push_back(length);
    const EdgelId next = successors[e];
    if (next != kInvalidEdgel) {
      length += (edgels_[next].position_px - edgels_[e].position_px).norm();
    }
    if (length > kReachPx) break;
    e = next;
  }
  return arm;
}

Continuation::Look Continuation::LookOf(const Arm& arm) const {
  Look look;
  const double share = 1.0 / static_cast<double>(arm.ids.size());
  for (const EdgelId id : arm.ids) {
    look.log_strength += share * std::log(std::max(edgels_[id].strength, 1e-3f));
    for (size_t side = 0; side < 2; ++side) {
      look.colors[side] += static_cast<float>(share) * colors_[id][side];
    }
  }
  return look;
}

double Continuation::GeometryCost(const Arm& behind, const Arm& ahead) const {
  const Edgel& from = edgels_[behind.ids[0]];
  const Edgel& to = edgels_[ahead.ids[0]];
  const Vector2d origin = (from.position_px + to.position_px) / 2;
  const Vector2d along = (from.Tangent() + to.Tangent()).normalized();
  BrokenParabola parabola;
  for (const Arm* arm : {&behind, &ahead}) {
    for (size_t k = 0; k < arm->ids.size() && arm->at_px[k] <= kGeometryReachPx; ++k) {
      const Vector2d d = edgels_[arm->ids[k]].position_px - origin;
      parabola.Add(d.dot(along), along.x() * d.y() - along.y() * d.x(), arm == &ahead);
    }
  }
  return parabola.Cost();
}

double Continuation::LookCost(const Arm& behind, const Arm& ahead) const {
  const Look a = LookOf(behind);
  const Look b = LookOf(ahead);
  double cost = std::pow((a.log_strength - b.log_strength) / kLogStrength, 2);
  for (size_t side = 0; side < 2; ++side) {
    cost += (a.colors[side] - b.colors[side]).squaredNorm() / (2 * kColorLevels * kColorLevels);
  }
  return std::min(cost, kMaxLookCost);
}

double Continuation::Score(EdgelId from, EdgelId to) const {
  if (from == kInvalidEdgel || to == kInvalidEdgel) return 0;
  const Arm behind = Follow(from, chaining_.prev);
  const Arm ahead = Follow(to, chaining_.next);
  const double length = std::min(behind.Length(), ahead.Length());
  if (length <= 0) return 0;
  return length * std::exp(-0.5 * (GeometryCost(behind, ahead) + LookCost(behind, ahead)));
}

bool Continuation::IsNearOnChain(EdgelId from, EdgelId to) const {
  for (const auto* successors : {&chaining_.next, &chaining_.prev}) {
    const Arm arm = Follow(from, *successors);
    if (std::find(arm.ids.begin(), arm.ids.end(), to) != arm.ids.end()) return true;
  }
  return false;
}

}  // namespace limn
