// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/refinement/control_graph.h"
#include "limn/refinement/refinement_options.h"
#include "limn/util/parallel.h"

namespace limn {

// Links connected by nodes or bends, with their unknowns and bends. Components share no unknowns.
struct Component {
  std::vector<int> links;
  std::vector<int> points;  // ascending
  std::vector<Bend> bends;
};
std::vector<Component> FindComponents(const ControlGraph& control);

// Square of the change of direction at a bend, divided by its variance.
double SquaredBend(const Bend& bend, const RefinementOptions& options, const ControlGraph& control);

// Moves the control points, world units, to minimize (algorithm/refinement.md#data-term)
//   the pulls of the edgels, weight * c^2 log(1 + (d / c)^2), where d is the distance to the
//   tangent line of the edgel, stored px, and c = robust_residual_px (pull_cost.h); |change of
//   direction|^2 / (bending_sigma^2 * length) for every bend, of the motion from the start if the
//   graph keeps its shape, with a Cauchy loss next to corners;
//   weak holds of points at their places in the drawing: along their curve, and at corners.
// Ceres solves each component separately; one without a usable solution stays. On request the
// covariances are set to the diagonal blocks of the inverse normal matrix at the minimum.
// Deterministic. Throws Cancelled.
void FitCurves(const std::vector<View>& views, const RefinementOptions& options,
               const RunContext& context, bool with_covariances, ControlGraph* control);

}  // namespace limn
