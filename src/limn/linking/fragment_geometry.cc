#include "limn/linking/fragment_geometry.h"

#include <cmath>

namespace limn {

FragmentPath::FragmentPath(const std::vector<Edgel>& edgels, const CurveFragment& fragment)
    : closed_(fragment.closed) {
  for (const EdgelId id : fragment.edgel_ids) {
    const Eigen::Vector2d& point = edgels[id].position_px;
    if (!points_.empty()) length_px_ += (point - points_.back()).norm();
    points_.push_back(point);
    arc_length_px_.push_back(length_px_);
  }
  if (closed_) length_px_ += (points_.front() - points_.back()).norm();
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
  const double angle = 0.5 * std::atan2(2 * scatter(0, 1), scatter(0, 0) - scatter(1, 1));
  arm.direction = Eigen::Vector2d(std::cos(angle), std::sin(angle));
  if (arm.direction.dot(last - first) < 0) arm.direction = -arm.direction;
  return arm;
}

}  // namespace limn
