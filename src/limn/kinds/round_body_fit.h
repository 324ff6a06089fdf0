// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/model/round_body.h"
#include "limn/model/view.h"

namespace limn {

// Where the loss of misfits from an outline begins to grow linearly, px.
constexpr double kOutlineRobustPx = 0.5;
// What calibration and sampling add to all edgels of a view alike, px.
constexpr double kAlikePx = 0.4;

// The line of sight through an edgel of an outline.
struct OutlineSight {
  ViewId view = -1;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  // of the view
  Eigen::Vector3d ray = Eigen::Vector3d::UnitZ();    // unit
  double px_per_unit = 1;                            // where it touches the body
  // The body there, as one outline tells.
  Eigen::Vector3d axis_point = Eigen::Vector3d::Zero();
  double radius = 0;
};

// The simplest of a sphere, a cylinder and a cone that all lines of sight touch (ours;
// algorithm/kinds.md#round-bodies). Nothing if fewer than 4 views show it, if a fifth of them miss
// it by more than 1.5 px, or if its radius is not known within 5 %. Time: that of at most three
// fits of few unknowns, linear in the number of lines of sight.
std::optional<RoundBody> FitRoundBody(const std::vector<OutlineSight>& sights);

}  // namespace limn
