// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "limn/geometry/curve_shape.h"
#include "limn/topology/topology_input.h"

namespace limn {

// A place on a circle and the edgels of the images there.
struct CirclePoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d tangent = Eigen::Vector3d::UnitX();  // unit
  std::vector<EdgelRef> support;                       // one per view at most
};

// Points of a whole circle (sweep_rad 2 pi) about 1 px apart, 12 at least, with the edgels of some
// views.
std::vector<CirclePoint> LookAlongCircle(const TopologyInput& input, const CircularArc& circle,
                                         double footprint, std::span<const ViewId> views,
                                         const SupportGate& gate);

// Moves a circle to the edgels beside it, by robust Gauss-Newton steps in its center, radius and
// direction; edgels are looked up anew for every step, ever nearer. Time: steps times points times
// views.
CircularArc FitCircleToEdgels(const TopologyInput& input, CircularArc circle, double footprint,
                              std::span<const ViewId> views);

}  // namespace limn
