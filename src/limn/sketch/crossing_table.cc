// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/crossing_table.h"

#include <algorithm>
#include <array>
#include <limits>

namespace limn {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
// Reaches of the first level differ by at most this.
constexpr float kReachRatio = 16;
// Cells are this share of the reach wide.
constexpr float kCellShare = 0.5;

}  // namespace

void CrossingTable::Fill(const std::vector<EpipolarCrossing>& crossings) {
  FindLevels(crossings);
  SortIntoCells(crossings);
  // Padding of the last batch is infinitely far from every place.
  const size_t size = crossings.size() + kBatch;
  crossing_.assign(size, -1);
  inverse_depth_.assign(size, kInfinity);
  slope_per_px_.assign(size, 0);
  gates_per_inverse_depth_.assign(size, 1);
  gates_per_slope_.assign(size, 0);
  for (size_t i = 0; i < crossings.size(); ++i) {
    const int slot = next_in_cell_[cell_of_[i]]++;
    crossing_[slot] = static_cast<int>(i);
    inverse_depth_[slot] = crossings[i].inverse_depth;
    slope_per_px_[slot] = crossings[i].slope_per_px;
    gates_per_inverse_depth_[slot] = crossings[i].across_px_per_inverse_depth * per_gate_px_;
    gates_per_slope_[slot] = crossings[i].rad_per_slope * per_gate_rad_;
  }
}

void CrossingTable::FindLevels(const std::vector<EpipolarCrossing>& crossings) {
  float max_across = 0;
  for (const EpipolarCrossing& crossing : crossings) {
    max_across = std::max(max_across, crossing.across_px_per_inverse_depth);
  }
  std::array<float, std::tuple_size_v<decltype(levels_)>> least_across;
  least_across.fill(kInfinity);
  levels_.fill({});
  level_of_.clear();
  for (const EpipolarCrossing& crossing : crossings) {
    const float across = crossing.across_px_per_inverse_depth;
    const int index = kReachRatio * across < max_across ? 1 : 0;
    level_of_.push_back(index);
    Level& level = levels_[index];
    const float depth = crossing.inverse_depth;
    level.low = level.count == 0 ? depth : std::min(level.low, depth);
    level.high = level.count == 0 ? depth : std::max(level.high, depth);
    least_across[index] = std::min(least_across[index], across);
    ++level.count;
  }
  for (size_t i = 0; i < levels_.size(); ++i) {
    if (levels_[i].count > 0) levels_[i].reach = 1 / (least_across[i] * per_gate_px_);
  }
}

void CrossingTable::SortIntoCells(const std::vector<EpipolarCrossing>& crossings) {
  int num_cells = 0;
  for (Level& level : levels_) {
    level.first_cell = num_cells;
    const float width = level.high - level.low;
    if (width > 0) {
      const float cells =
          std::min(static_cast<float>(level.count), width / (kCellShare * level.reach));
      level.cells_per_unit = cells / width;
      level.last_cell = static_cast<int>(cells);
    }
    num_cells += level.last_cell + 1;
  }
  cell_begin_.assign(num_cells + 1, 0);
  cell_of_.clear();
  for (size_t i = 0; i < crossings.size(); ++i) {
    const Level& level = levels_[level_of_[i]];
    cell_of_.push_back(level.first_cell + level.Cell(crossings[i].inverse_depth));
    ++cell_begin_[cell_of_.back() + 1];
  }
  for (int cell = 0; cell < num_cells; ++cell) cell_begin_[cell + 1] += cell_begin_[cell];
  next_in_cell_.assign(cell_begin_.begin(), cell_begin_.end() - 1);
}

}  // namespace limn
