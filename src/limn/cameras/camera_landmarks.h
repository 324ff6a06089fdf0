// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

#include "limn/cameras/camera_problem.h"
#include "limn/cameras/camera_scene.h"
#include "limn/refinement/control_graph.h"

namespace limn {

// The curves of small pictures as the edgels in them, and the views of the pictures as stored.
struct LandmarkInput {
  const std::vector<View>& views;
  const std::vector<ImageCurves>& curves;  // through the lenses of the small pictures
  int factor = 1;                          // PictureLevel::factor
  // Per camera whose parameters are adjusted (ParametersPerPx).
  const std::map<int, Eigen::VectorXd>& parameters_per_px;
  double robust_px = 0.5;  // of edgels
};

// By how much the distance from an edgel changes with the parameters, counted in px of their
// effect. Empty if those of this camera stay.
ParameterRow EdgelByParameters(const LandmarkInput& input, const EdgelPull& pull);

// Samples of the links that are not frozen, as landmarks that move across their links: every n-th,
// so that there are not many more lines than `max_lines`; the weights stand for the others, too.
std::vector<Landmark> CurveLandmarks(const LandmarkInput& input, const ControlGraph& control,
                                     size_t max_lines);

// Points of the sparse model that two views or more see, from directions that are not all the same,
// and the places of these points in the list.
struct PointLandmarks {
  std::vector<Landmark> landmarks;
  std::vector<size_t> points;
};
PointLandmarks LandmarksOfPoints(const LandmarkInput& input, const std::vector<SeenPoint>& points);

}  // namespace limn
