// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/linking/link_graph.h"
#include "limn/linking/side_colors.h"

namespace limn {

// How well one chain continues another, over up to 30 px of either.
class Continuation {
 public:
  // All must outlive this object. `colors` as from MeasureSideColors.
  Continuation(const std::vector<Edgel>& edgels, const std::vector<SideColors>& colors,
               const Chaining& chaining)
      : edgels_(edgels), colors_(colors), chaining_(chaining) {}

  // Scores the fragment hypothesis that the chain up to `from` continues with the one that begins
  // at `to`. The score is the length that the shorter one adds, px, times exp(-cost / 2). The cost
  // is 0 where both are one parabola near the step, alike in contrast and in the colors on both
  // sides. 0 if either edgel is kInvalidEdgel.
  double Score(EdgelId from, EdgelId to) const;

  // Whether `to` follows `from` on its chain, either way, within that length.
  bool IsNearOnChain(EdgelId from, EdgelId to) const;

 private:
  // The edgels of a chain from one on, in its order or against it, and their arc lengths from it.
  struct Arm {
    std::vector<EdgelId> ids;
    std::vector<double> at_px;
    double Length() const { return at_px.back(); }
  };
  // The mean appearance of the edgels of an arm.
  struct Look {
    double log_strength = 0;
    SideColors colors = {Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
  };

  Arm Follow(EdgelId start, const std::vector<EdgelId>& successors) const;
  Look LookOf(const Arm& arm) const;
  double GeometryCost(const Arm& behind, const Arm& ahead) const;
  double LookCost(const Arm& behind, const Arm& ahead) const;

  const std::vector<Edgel>& edgels_;
  const std::vector<SideColors>& colors_;
  const Chaining& chaining_;
};

}  // namespace limn
