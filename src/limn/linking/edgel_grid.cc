// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/edgel_grid.h"

#include <algorithm>
#include <cmath>

namespace limn {

EdgelGrid::EdgelGrid(const std::vector<Edgel>& edgels, double cell_px) : cell_px_(cell_px) {
  if (!edgels.empty()) {
    Eigen::Vector2d max = edgels[0].position_px;
    min_ = max;
    for (const Edgel& edgel : edgels) {
      min_ = min_.cwiseMin(edgel.position_px);
      max = max.cwiseMax(edgel.position_px);
    }
    cols_ = static_cast<int>((max.x() - min_.x()) / cell_px) + 1;
    rows_ = static_cast<int>((max.y() - min_.y()) / cell_px) + 1;
  }
  begin_of_cell_.assign(static_cast<size_t>(cols_) * rows_ + 1, 0);
  std::vector<int> cell_of(edgels.size());
  for (size_t i = 0; i < edgels.size(); ++i) {
    const Eigen::Vector2d& p = edgels[i].position_px;
    cell_of[i] = CellRow(p.y()) * cols_ + CellColumn(p.x());
    ++begin_of_cell_[cell_of[i] + 1];
  }
  for (size_t c = 1; c < begin_of_cell_.size(); ++c) begin_of_cell_[c] += begin_of_cell_[c - 1];
  std::vector<int> next(begin_of_cell_.begin(), begin_of_cell_.end() - 1);
  ids_.resize(edgels.size());
  positions_.resize(edgels.size());
  for (size_t i = 0; i < edgels.size(); ++i) {
    const int place = next[cell_of[i]]++;
    ids_[place] = static_cast<EdgelId>(i);
    positions_[place] = edgels[i].position_px;
  }
}

// Places before the first cell are clamped to it, so that rounding towards zero does no harm.
int EdgelGrid::CellColumn(double x) const {
  return std::clamp(static_cast<int>((x - min_.x()) / cell_px_), 0, cols_ - 1);
}

int EdgelGrid::CellRow(double y) const {
  return std::clamp(static_cast<int>((y - min_.y()) / cell_px_), 0, rows_ - 1);
}

void EdgelGrid::Near(const Eigen::Vector2d& point, double radius_px,
                     std::vector<EdgelId>* found) const {
  const int x0 = CellColumn(point.x() - radius_px);
  const int x1 = CellColumn(point.x() + radius_px);
  const int y1 = CellRow(point.y() + radius_px);
  const double squared = radius_px * radius_px;
  for (int y = CellRow(point.y() - radius_px); y <= y1; ++y) {
    const int begin = begin_of_cell_[y * cols_ + x0];
    const int end = begin_of_cell_[y * cols_ + x1 + 1];
    for (int i = begin; i < end; ++i) {
      if ((positions_[i] - point).squaredNorm() <= squared) found->push_back(ids_[i]);
    }
  }
}

}  // namespace limn
