// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "limn/model/view.h"
#include "limn/rods/rod.h"
#include "limn/topology/topology_input.h"

namespace limn {

// What one view shows of a rod at one place: an edge on either side, either both brighter or both
// darker outside.
struct RodSight {
  ViewId view = -1;
  // Unit vector from the axis to the first outline, across the axis and the line of sight; the
  // second outline lies on the opposite side.
  Eigen::Vector3d to_outline = Eigen::Vector3d::Zero();
  std::array<EdgelRef, 2> edgels;
  // How far from the axis the edges appear, world units, and its derivative by the radius.
  double seen_radius = 0;
  double seen_per_radius = 1;

  // Unit vector from the axis to outline 0 or 1.
  Eigen::Vector3d ToOutline(int side) const {
    return side == 0 ? to_outline : Eigen::Vector3d(-to_outline);
  }
};

// Blur moves the two edges of a bar apart. Half the distance, px, at which they appear
// (algorithm/rods.md#blur).
double SeenHalfWidth(double half_width_px);

// A place on the axis of a rod: the share t of the way from axis point `segment` to the next.
struct RodPlace {
  int segment = 0;
  double t = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d tangent = Eigen::Vector3d::UnitX();  // unit
  std::vector<RodSight> sights;                        // one per view at most

  // Enough views show it to determine it.
  bool IsShown() const { return sights.size() >= 3; }
};

// Places every 2 px of the axis from point `first` on, with what some views show there: edges
// within `gate` of the outlines (algorithm/rods.md#outlines). Time: places times views.
std::vector<RodPlace> LookAlongRod(const TopologyInput& input, const Rod& rod, size_t first,
                                   std::span<const ViewId> views, const SupportGate& gate);

// Share of the places that are shown.
double ShownShare(std::span<const RodPlace> places);

}  // namespace limn
