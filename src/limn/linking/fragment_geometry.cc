#include "limn/linking/fragment_geometry.h"

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

FragmentPath::Arm FragmentPath::ArmAt(int i, int direction, double reach_px) const {
  Arm arm;
  Walk(i, direction, reach_px, [&](int j, double walked) {
    arm.direction += points_[j] - points_[i];
    arm.length_px = walked;
  });
  const double norm = arm.direction.norm();
  if (norm > 0) arm.direction /= norm;
  return arm;
}

}  // namespace limn
