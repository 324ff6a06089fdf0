#pragma once

#include <vector>

#include "limn/model/scene_hints.h"
#include "limn/refinement/curve_fit.h"

namespace limn {

// Moves cameras, control points and scene points together (algorithm/refinement.md#cameras) to
// minimize the sum of FitCurves, with
//   sum over pixels of points of Cauchy(distance to the projected point / 0.5 px), stored px,
// and a weak hold of every camera at its given pose, with a standard deviation of 10 px in the
// image of the scene. The holds fix the position, orientation and scale of the whole, which images
// do not determine. Frozen links only follow their nodes and do not affect the cameras. The views
// are the given ones, not corrected. `positions` belong to `points`; points stay where they are if
// fewer than two views see them, if all see them from nearly the same direction, or if they would
// end behind a view. Returns false, and changes nothing, if the solver fails. One sparse system,
// solved by Ceres on one thread. Deterministic. Throws Cancelled. Time per step: unknowns of the
// curves times the square of those of the cameras.
bool FitPoses(const std::vector<View>& views, const std::vector<ScenePoint>& points,
              const RefinementOptions& options, const RunContext& context,
              CameraCorrections* corrections, ControlGraph* control,
              std::vector<Eigen::Vector3d>* positions);

}  // namespace limn
