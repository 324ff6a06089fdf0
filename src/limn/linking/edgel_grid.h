// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/edgel.h"

namespace limn {

// Look-up of the edgels near a point: a hash grid with the edgels of each square cell stored
// together.
class EdgelGrid {
 public:
  EdgelGrid(const std::vector<Edgel>& edgels, double cell_px);

  // Append the edgels within `radius_px` of the point, in no particular order.
  void Near(const Eigen::Vector2d& point, double radius_px, std::vector<EdgelId>* found) const;

 private:
  int CellColumn(double x) const;
  int CellRow(double y) const;

  double cell_px_;
  Eigen::Vector2d min_ = Eigen::Vector2d::Zero();
  int cols_ = 1;
  int rows_ = 1;
  std::vector<int> begin_of_cell_;  // one more than cells
  std::vector<EdgelId> ids_;
  std::vector<Eigen::Vector2d> positions_;  // of ids_
};

}  // namespace limn
