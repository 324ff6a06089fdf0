#pragma once

#include <vector>

#include <ceres/problem.h>

#include "limn/refinement/camera_corrections.h"
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

// Adds the terms of a component to a least squares problem whose unknowns are the positions in
// `control`, world units, and the corrections of the cameras, unless null
// (algorithm/refinement.md#data-term):
//   the pulls of the edgels (pull_cost.h);
//   |change of direction|^2 / (bending_sigma^2 * length) for every bend, with a Cauchy loss next to
//   corners;
//   weak holds of points at their places in the drawing: along their curve, and at corners.
void AddTerms(const std::vector<View>& views, const RefinementOptions& options,
              const Component& component, CameraCorrections* cameras, ControlGraph* control,
              ceres::Problem* problem);

// Minimizes with Ceres by sparse Cholesky factorization of the normal matrix, on one thread.
// Returns false, and changes nothing, if there is no usable solution. Deterministic. Throws
// Cancelled.
bool Minimize(int max_iterations, const RunContext& context, ceres::Problem* problem);

// Square of the change of direction at a bend, divided by its variance.
double SquaredBend(const Bend& bend, const RefinementOptions& options, const ControlGraph& control);

// Moves the control points to minimize
//   sum over pulls of weight * c^2 log(1 + (d / c)^2)
// and the other terms above, where d is the distance to the tangent line of the edgel,
// stored px, and c = robust_residual_px (pull_cost.h; algorithm/refinement.md#data-term). Ceres
// solves each component separately. On request the covariances are set to the diagonal blocks of
// the inverse normal matrix at the minimum. Deterministic.
void FitCurves(const std::vector<View>& views, const RefinementOptions& options,
               const RunContext& context, bool with_covariances, ControlGraph* control);

}  // namespace limn
