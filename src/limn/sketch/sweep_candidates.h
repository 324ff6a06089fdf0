// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "limn/sketch/crossing_table.h"
#include "limn/sketch/depth_modes.h"
#include "limn/sketch/epipolar_crossings.h"
#include "limn/sketch/sketch_options.h"

namespace limn {

// Elects the depths of a sample on which the image curves of several views agree
// (algorithm/sketch.md#swept-sketch). Every view has one vote for a depth: its crossing with the
// nearest depth and slope, weighted by tangency. Inverse depth and slope of a candidate are the
// means of its voters by their weights.
class DepthElection {
 public:
  // Largest number of candidates.
  static constexpr size_t kMaxModes = 8;

  // `focal_px` is the primary view's.
  DepthElection(double focal_px, const SketchOptions& options);

  // The candidates with most votes among all that crossings propose, best first. `crossings` are
  // those of one sample, grouped by view, of at most 64 views. Worst-case time: crossings squared.
  std::vector<DepthMode> Find(const std::vector<EpipolarCrossing>& crossings);

  // The candidates near the proposed places. Time: crossings times proposals.
  std::vector<DepthMode> FindNear(const std::vector<EpipolarCrossing>& crossings,
                                  const std::vector<DepthPlace>& proposals);

 private:
  // Largest number of views: each has a bit.
  static constexpr int kMaxViews = 64;

  // The crossing of a view that is nearest to a place.
  struct Voter {
    int crossing = -1;
    float distance = 1;  // squared, in gates
  };

  std::optional<DepthMode> Vote(const std::vector<EpipolarCrossing>& crossings,
                                const DepthPlace& place, double least_score);
  float TangencyWeight(const EpipolarCrossing& crossing) const;

  double focal_px_;
  float sin_low_;
  float sin_high_;
  float min_weight_;
  CrossingTable table_;
  std::vector<DepthPlace> seeds_;
  std::vector<float> weights_;             // per crossing
  std::array<Voter, kMaxViews> voters_{};  // per view, of the latest place
};

}  // namespace limn
