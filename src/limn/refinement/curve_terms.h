#pragma once

#include <array>

#include <ceres/problem.h>

#include "limn/refinement/control_graph.h"
#include "limn/refinement/refinement_options.h"

namespace limn {

// What holds control points beside the edgels that pull at them, as terms of a least squares
// problem whose unknowns are the positions in `control`, world units.

// Hold a point weakly to where it was in the drawing: along its curve, and at a corner.
void AddHold(int point, ControlGraph* control, ceres::Problem* problem);

// The penalty on the change of direction at the middle one of three neighbors.
void AddBend(const std::array<int, 3>& bend, const RefinementOptions& options,
             ControlGraph* control, ceres::Problem* problem);

// The square of that change over its variance.
double SquaredBend(const std::array<int, 3>& bend, const RefinementOptions& options,
                   const ControlGraph& control);

}  // namespace limn
