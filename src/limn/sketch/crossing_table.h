// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "limn/sketch/epipolar_crossings.h"
#include "limn/util/float4.h"

namespace limn {

// The crossings of one sample, sorted by inverse depth so that those that accept a place are found
// quickly, several at once. A crossing accepts the places within its gates: a distance across the
// curve and an angle to it.
class CrossingTable {
 public:
  CrossingTable(double gate_px, double gate_rad)
      : per_gate_px_(static_cast<float>(1 / gate_px)),
        per_gate_rad_(static_cast<float>(1 / gate_rad)) {}

  // Replaces the contents. Linear in the number of crossings.
  void Fill(const std::vector<EpipolarCrossing>& crossings);

  // Calls visit(index into the crossings, squared distance in gates) for all that accept the place;
  // some may be visited twice. Expected time: crossings near in depth alone.
  template <typename Visit>
  void ForEachNear(const DepthPlace& place, Visit&& visit) const {
    for (const Level& level : levels_) {
      const int end =
          cell_begin_[level.first_cell + level.Cell(place.inverse_depth + level.reach) + 1];
      int i = cell_begin_[level.first_cell + level.Cell(place.inverse_depth - level.reach)];
      // The last batch may extend beyond the end: its entries are compared like the rest.
      for (; i < end; i += kBatch) VisitBatch(i, place, visit);
    }
  }

 private:
  // Number of crossings compared with a place at once.
  static constexpr int kBatch = 8;
  // Crossings of small reach, the extent of their gates in inverse depth, or the others.
  struct Level {
    float reach = 0;  // the greatest
    float low = 0;    // inverse depth where the first cell begins
    float high = 0;
    float cells_per_unit = 0;
    int first_cell = 0;
    int last_cell = 0;  // counted from the first
    int count = 0;

    int Cell(float inverse_depth) const {
      const float cell = (inverse_depth - low) * cells_per_unit;
      // In this order even NaN, from an infinite range, gives a valid cell.
      return static_cast<int>(std::max(0.f, std::min(static_cast<float>(last_cell), cell)));
    }
  };

  void FindLevels(const std::vector<EpipolarCrossing>& crossings);
  void SortIntoCells(const std::vector<EpipolarCrossing>& crossings);

  template <typename Visit>
  void VisitBatch(int begin, const DepthPlace& place, Visit&& visit) const {
    std::array<float, kBatch> distances;
    unsigned near = 0;
    for (int k = 0; k < kBatch; k += 4) {
      const Float4 offset = (Load4(&inverse_depth_[begin + k]) - place.inverse_depth) *
                            Load4(&gates_per_inverse_depth_[begin + k]);
      const Float4 turn = (Load4(&slope_per_px_[begin + k]) - place.slope_per_px) *
                          Load4(&gates_per_slope_[begin + k]);
      const Float4 distance = offset * offset + turn * turn;
      Store4(distance, distances.data() + k);
      near |= Bits4(distance < Splat4(1)) << k;
    }
    for (; near != 0; near &= near - 1) {
      const int k = std::countr_zero(near);
      visit(crossing_[begin + k], distances[k]);
    }
  }

  float per_gate_px_;
  float per_gate_rad_;
  std::array<Level, 2> levels_;
  // Per cell, where its crossings begin in the arrays below.
  std::vector<int> cell_begin_;
  std::vector<int> crossing_;
  std::vector<float> inverse_depth_;
  std::vector<float> slope_per_px_;
  std::vector<float> gates_per_inverse_depth_;
  std::vector<float> gates_per_slope_;
  // Per crossing, used while sorting.
  std::vector<int> level_of_;
  std::vector<int> cell_of_;
  std::vector<int> next_in_cell_;
};

}  // namespace limn
