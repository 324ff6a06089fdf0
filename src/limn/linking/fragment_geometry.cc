// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/fragment_geometry.h"

#include <cmath>

namespace limn {
namespace {

// Direction of the largest scatter, by the half of the angle of (xx - yy, 2 xy).
Eigen::Vector2d PrincipalAxis(const Eigen::Matrix2d& scatter) {
  const double difference = scatter(0, 0) - scatter(1, 1);
  const double twice = 2 * scatter(0, 1);
  const double length = std::sqrt(difference * difference + twice * twice);
  if (length == 0) return {1, 0};
  return difference > 0 ? Eigen::Vector2d(difference + length, twice).normalized()
                        : Eigen::Vector2d(twice, length - difference).normalized();
}

}  // namespace

FragmentPath::FragmentPath(const std::vector<Edgel>& edgels, const CurveFragment& fragment)
    : closed_(fragment.closed) {
  const size_t size = fragment.edgel_ids.size();
  points_.reserve(size);
  arc_length_px_.reserve(size);
  step_px_.reserve(size);
  for (const EdgelId id : fragment.edgel_ids) {
    const Eigen::Vector2d& point = edgels[id].position_px;
    if (!points_.empty()) {
      step_px_.push_back((point - points_.back()).norm());
      length_px_ += step_px_.back();
    }
    points_.push_back(point);
    arc_length_px_.push_back(length_px_);
  }
  step_px_.push_back((points_.front() - points_.back()).norm());
  if (closed_) length_px_ += step_px_.back();
}

FragmentPath::Arm FragmentPath::ArmAt(int i, int direction, double from_px, double to_px) const {
  Arm arm;
  int count = 0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  Eigen::Vector2d first = points_[i];
  Eigen::Vector2d last = points_[i];
  const auto add = [&](int j, double walked) {
    if (walked < from_px) return;
    const Eigen::Vector2d p = points_[j] - points_[i];
    if (count == 0) first = points_[j];
    last = points_[j];
    sum += p;
    squares += p * p.transpose();
    ++count;
    arm.reach_px = walked;
  };
  add(i, 0);
  Walk(i, direction, to_px, add);
  if (count < 2) return arm;
  // Principal axis of the scatter, pointing from the first vertex to the last.
  const Eigen::Matrix2d scatter = squares - sum * sum.transpose() / count;
  arm.direction = PrincipalAxis(scatter);
  if (arm.direction.dot(last - first) < 0) arm.direction = -arm.direction;
  return arm;
}

}  // namespace limn
