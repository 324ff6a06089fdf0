// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"

namespace limn {

// The principal axis of some points: a line through their mean in a unit direction of either sign.
struct AxisLine {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
};
AxisLine FitLine(std::span<const Eigen::Vector3d> points);

// The line along which a link leaves at an end: the principal axis of its last 12 px without the
// outermost 2, which corners round (algorithm/topology.md#reach).
struct LinkTip {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    // on the line, nearest to the end
  Eigen::Vector3d outward = Eigen::Vector3d::Zero();  // unit; zero for a link without extent
  double footprint = 1;                               // at the end
  // The direction at the end itself if the link keeps bending as it does between these distances;
  // that of the line if this is unknown.
  Eigen::Vector3d bent_outward = Eigen::Vector3d::Zero();
};
LinkTip TipOf(const DrawingLink& link, int end, double footprint);

// Uses the footprint of the end's vertex. A link without vertices gets a tip without direction.
LinkTip TipOf(const DrawingLink& link, int end);

// How much the path from one end into another turns, rad; 0 where they continue as one smooth
// curve. It is the turn from line to line or, if that is less, the turn between the ends
// themselves: where both bend alike, the lines differ by the bend between their middles.
double TurnBetween(const LinkTip& a, const LinkTip& b);

// How much more a closed link turns where it begins than it does elsewhere, in the median, rad:
// between chords of 4 points, or of an eighth of a short link. Near 0 on a circle, however small;
// pi for fewer than 8 points, which are no circle.
double SeamTurn(const DrawingLink& link);

// The angle between two directions, rad; pi / 2 if one is zero, which continues nothing.
double TurnBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

// The pairs of tips at one node, by index, that turn by less than this: smoothest first, each tip
// at most once.
std::vector<std::pair<size_t, size_t>> SmoothPairs(const std::vector<LinkTip>& tips,
                                                   double max_turn_rad);

// Position of the end.
const Eigen::Vector3d& EndPoint(const DrawingLink& link, int end);

// ArcPx, LengthPx and NumSketchSamples need the link's vertices.

// Arc length between two points of a link, from <= to, px.
double ArcPx(const DrawingLink& link, int from, int to);
double LengthPx(const DrawingLink& link);

// Unit direction of the link at a point; zero if the neighboring points coincide.
Eigen::Vector3d TangentAt(const DrawingLink& link, int index);

// At most 60 point indices, evenly spaced, at which a link is tested.
std::vector<int> ProbePoints(const DrawingLink& link);

// Inverse variance, per direction across the curve, of a position about which nothing is known: 30
// px of standard deviation. As a prior it matters only where no sample determines the position.
double WeakInformation(double footprint);

// Standard deviation across a curve: the root of the mean of the two variances, each at most that
// of WeakInformation.
double SigmaAcross(const Eigen::Matrix3d& information, double footprint);

// The vertex for a point added beside this one: as accurate, but without support.
LinkVertex Bare(const LinkVertex& vertex);

// Number of sketch samples that a link stands for.
int64_t NumSketchSamples(const DrawingLink& link);

}  // namespace limn
