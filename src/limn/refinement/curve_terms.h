#pragma once

#include <cstdint>
#include <vector>

#include <ceres/problem.h>

#include "limn/refinement/camera_corrections.h"
#include "limn/refinement/edgel_matches.h"

namespace limn {

// The data of a fit.
struct FitInput {
  const std::vector<View>& views;
  const std::vector<ImageCurves>& curves;
  const std::vector<LinkMatches>& matches;
  // Per link, nonzero if its inner points are not unknowns but follow its nodes.
  const std::vector<uint8_t>& frozen;
};

// Links connected by nodes or bends, with their unknowns and bends. Components share no unknowns.
struct Component {
  std::vector<int> links;
  std::vector<int> points;  // ascending
  std::vector<Bend> bends;
};
std::vector<Component> FindComponents(const std::vector<uint8_t>& frozen,
                                      const ControlGraph& control);

// Adds the terms of a component to a least squares problem whose unknowns are the positions in
// `control`, world units, and the corrections of the cameras, unless null (ALGORITHM.md 16.3 to
// 16.5):
//   the pulls of the edgels (pull_cost.h);
//   |change of direction|^2 / (bending_sigma^2 * length) for every bend, with a Cauchy loss next to
//   corners;
//   weak holds of points at their places in the drawing: along their curve, and at corners.
void AddTerms(const FitInput& input, const RefinementOptions& options, const Component& component,
              CameraCorrections* cameras, ControlGraph* control, ceres::Problem* problem);

// Weight of a pull divided by the variance of its distance, 1 / px^2.
double WeightOf(const EdgelPull& pull, const std::vector<ImageCurves>& curves);

// Square of the change of direction at a bend, divided by its variance.
double SquaredBend(const Bend& bend, const RefinementOptions& options, const ControlGraph& control);

}  // namespace limn
