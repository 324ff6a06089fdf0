// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/geometry/polyline.h"
#include "limn/model/curve3d.h"
#include "limn/model/drawing_graph.h"
#include "limn/support/edgel_residual.h"

namespace limn {

// An edgel through whose tangent line a place on a link should project.
struct EdgelPull {
  EdgelRef ref;
  EdgelLine line;
  // Share of an independent observation, in (0, 1], over the variance of the residual, 1 / px^2.
  double weight = 0;
  double residual_px = 0;
  bool bright_left = false;  // whether the left side, walking along the link, is brighter
  bool crowded = false;      // whether another link runs so near that their edges may blur into one
};

// A place on a link, at t in [0, 1] on a segment, and the edgels that pull at it: at most one per
// view, ascending by view.
struct FitSample {
  int segment = 0;
  double t = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d tangent = Eigen::Vector3d::Zero();
  double arc_px = 0;  // from the first point of the link
  std::vector<EdgelPull> pulls;
};

// A link as the ids of its control points, first and last included; a closed one returns to the
// first.
struct ControlLink {
  std::vector<int> points;
  std::vector<ViewId> views;  // in which its edgels are sought, ascending
  // Data within this length of either end is ignored, px, because edges are rounded at corners.
  std::array<double, 2> skip_px = {0, 0};
  std::vector<FitSample> samples;  // in order, as matched last (MatchEdgels)
  bool frozen = false;             // its inner points are not unknowns but follow its nodes

  int NumSegments() const { return static_cast<int>(points.size()) - 1; }
};

// Three neighbors along a curve.
using Bend = std::array<int, 3>;

// The drawing as the unknowns of a fit (algorithm/refinement.md#unknowns), and their data. Links
// that meet at a node share the control point there. Control point n < number of nodes is node n.
struct ControlGraph {
  std::vector<Eigen::Vector3d> position;
  std::vector<Eigen::Vector3d> start;    // position in the drawing
  std::vector<Eigen::Vector3d> tangent;  // unit or zero, of any link through the point
  std::vector<double> footprint;         // world units per px (LinkFootprint)
  // Whether links meet here in different directions, so that no tangent defines how to hold the
  // point.
  std::vector<uint8_t> corner;
  std::vector<std::optional<Eigen::Matrix3d>> covariance;  // world units squared, if fitted
  // Points that must stay in place, with their standard deviations, world units. Empty: none.
  std::vector<std::optional<double>> held;
  std::vector<ControlLink> links;  // as in the graph
  std::vector<Bend> bends;         // also through smooth nodes
  // Whether bends are those of the motion from the start, so that the shape is kept, instead of
  // those of the curve.
  bool keeps_shape = false;
};

// Control points about `spacing_px` apart along every link. Linear time.
ControlGraph MakeControlGraph(const DrawingGraph& graph, const std::vector<View>& views,
                              double spacing_px);

// Direction from control point `first` to `last` of a link, clamped to its ends; zero if they
// coincide.
Eigen::Vector3d Tangent(const ControlGraph& control, const ControlLink& link, int first, int last);

// Tangents from the neighbors along the links.
void UpdateTangents(ControlGraph* control);

// Distances of a link from the edgels that pull at it, px.
std::vector<double> ResidualsPx(const ControlLink& link);

// Samples that enough views show, so that they have pulls.
int NumShown(const ControlLink& link);

// Freezes the links of which too small a share is shown, and no others: they follow their nodes.
void FreezeUnshown(ControlGraph* control);

// Moves a polyline to new ends: every point by a mean of the motions of both ends, the nearer end
// weighing more.
void FollowEnds(const Eigen::Vector3d& first, const Eigen::Vector3d& last, Polyline3d* points);

// The same for the control points of frozen links whose nodes have moved from `before`.
void FollowNodes(const std::vector<Eigen::Vector3d>& before, ControlGraph* control);

}  // namespace limn
