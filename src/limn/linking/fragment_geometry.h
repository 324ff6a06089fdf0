// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/curve_fragment.h"

namespace limn {

// The polyline of a fragment with its arc length, for walking along it.
class FragmentPath {
 public:
  FragmentPath(const std::vector<Edgel>& edgels, const CurveFragment& fragment);

  int size() const { return static_cast<int>(points_.size()); }
  bool closed() const { return closed_; }
  // Includes the closing step of a closed fragment.
  double Length() const { return length_px_; }
  const Eigen::Vector2d& Point(int i) const { return points_[i]; }
  // Arc length from the first vertex.
  double ArcLength(int i) const { return arc_length_px_[i]; }

  // Visit the vertices after vertex i (direction +1) or before it (-1), nearest first, up to
  // `reach_px` of arc length: visit(index, arc length from i > 0). Wraps around closed fragments,
  // but never returns to i.
  template <typename Visit>
  void Walk(int i, int direction, double reach_px, const Visit& visit) const {
    double walked = 0;
    int at = i;
    for (int step = 1; step < size(); ++step) {
      int to = at + direction;
      if (to < 0 || to >= size()) {
        if (!closed_) return;
        to = direction > 0 ? 0 : size() - 1;
      }
      walked += step_px_[direction > 0 ? at : to];
      if (walked > reach_px) return;
      at = to;
      visit(at, walked);
    }
  }

  // The straight line fitted to the vertices on one side of vertex i whose arc length from it is
  // between `from_px` (the vertex itself included if 0) and `to_px`: its direction away from i
  // (unit; zero vector if fewer than two vertices), and how far the vertices reach.
  struct Arm {
    Eigen::Vector2d direction = Eigen::Vector2d::Zero();
    double reach_px = 0;
  };
  Arm ArmAt(int i, int direction, double from_px, double to_px) const;

 private:
  std::vector<Eigen::Vector2d> points_;
  std::vector<double> arc_length_px_;
  std::vector<double> step_px_;  // from every vertex to the next; of the last one to the first
  double length_px_ = 0;
  bool closed_ = false;
};

}  // namespace limn
