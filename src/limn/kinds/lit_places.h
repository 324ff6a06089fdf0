// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

// A place on a believed link, and the surface it lies on.
struct LitPlace {
  LinkId link = -1;
  Eigen::Vector3d position_in_world = Eigen::Vector3d::Zero();
  Eigen::Vector3d tangent = Eigen::Vector3d::Zero();
  double footprint = 0;
  // Of the plane through the places around it, on the side of most of its views; zero if the places
  // are too few or on a line, or if the views do not tell.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  // Most places around it lie on that plane.
  bool on_plane = false;
};

constexpr double kPlaceStepPx = 6;

// Places along the links that are not tentative, rods and contours too, in their order, at most
// kPlaceStepPx apart. Linear time in their number times that of those within 60 px.
std::vector<LitPlace> PlacesOfLinks(const DrawingGraph& graph, const std::vector<View>& views,
                                    const RunContext& context);

}  // namespace limn
