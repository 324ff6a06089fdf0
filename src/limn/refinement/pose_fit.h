#pragma once

#include <vector>

#include "limn/model/scene_hints.h"
#include "limn/refinement/curve_terms.h"

namespace limn {

// Move cameras, control points and scene points together to minimize the sum of FitCurves, with
//   sum over pixels of points of Cauchy(distance to the projected point / 0.5 px), stored px,
// and a weak hold of every camera where it was given: a change of 10 px in the image of the scene
// is one standard deviation. That fixes what images do not tell: place, orientation and scale of
// the whole. Frozen links only follow their nodes and say nothing of the cameras. The views are as
// given, not corrected. `positions` are of `points`; here those stay that fewer than two views see,
// or all from nearly the same direction, and those that would end behind a view. False, and nothing
// changed, if the solver fails. With Ceres, one sparse system, one thread. Deterministic. Throws
// Cancelled. Time per step: unknowns of the curves times the square of those of the cameras.
bool FitPoses(const FitInput& input, const std::vector<ScenePoint>& points,
              const RefinementOptions& options, const RunContext& context,
              CameraCorrections* corrections, ControlGraph* control,
              std::vector<Eigen::Vector3d>* positions);

}  // namespace limn
