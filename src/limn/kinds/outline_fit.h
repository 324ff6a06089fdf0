// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/kinds/round_body_fit.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view_finder.h"
#include "limn/topology/topology_input.h"

namespace limn {

// A smooth body beside a link: at every probe a circle in the plane across the link, of which
// views see the outline.
struct BodyBeside {
  std::vector<Eigen::Vector3d> axis;  // per probe, the center of the circle
  // World units. Views with the direction of the link upward see the outline to the left of the
  // axis if it is positive, to the right if it is negative; 0: an edge.
  double radius = 0;
};

// How well a body explains the edgels of all views near a link, compared with an edge in space.
struct OutlineEvidence {
  BodyBeside body;
  double footprint = 0;
  // Logarithm of the ratio of the likelihoods of the body and of an edge, over the views; less that
  // of the best body on the other side.
  double log_ratio = 0;
  double body_rms_px = 0;  // of the edgels of the views that show the outline
  double edge_rms_px = 0;  // of those that show the edge; 0 if fewer than 4 views do
  // Views where the outline is farther than 1 px from the edge, and how many of them show it.
  int num_moved = 0;
  int num_moved_shown = 0;
};

// Fits an edge and bodies of several radii on both sides of a link to the edgels of views within 50
// degrees of those that support it, with the same brighter side (ours;
// algorithm/kinds.md#smooth-bodies). Bodies are not tried, and the ratio is 0, where the edge
// explains what all views but one show. Time: at most 13 fits of 5 steps, 16 places times
// views, of which at most 40 are used.
OutlineEvidence CompareWithBodies(const TopologyInput& images, const ViewFinder& finder,
                                  const DrawingLink& link);

// The edgels along the outlines of a body beside a link, in the views that it was fitted to.
std::vector<OutlineSight> SightsOfOutline(const TopologyInput& images, const ViewFinder& finder,
                                          const DrawingLink& link, const BodyBeside& body);

}  // namespace limn
