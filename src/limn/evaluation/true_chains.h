// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "limn/evaluation/curve_samples.h"
#include "limn/model/curve_set.h"

namespace limn {

// A true curve as one would draw it: from a corner, junction or end to the next, or closed.
struct TrueChain {
  Polyline3d points;
  double length = 0;
};

// A chain leaving a node, from its start or from its end.
struct TrueArm {
  int chain = -1;
  bool from_end = false;
};

// Where chains end: an end (one arm), a corner (two) or a junction.
struct TrueNode {
  Eigen::Vector3d position_in_world = Eigen::Vector3d::Zero();
  std::vector<TrueArm> arms;
  // That of the truth's own node there, if it has nodes; else the number of arms.
  int degree = 0;
  JunctionKind kind = JunctionKind::kUnknown;  // that of the truth's own node
};

// A part of a polyline of the truth, between two of its arc lengths, and where it is on its chain.
struct TruePiece {
  double from = 0;
  double to = 0;
  int chain = -1;
  double chain_from = 0;  // arc length on the chain at which the piece begins
  bool reversed = false;  // the chain runs through it backwards

  double ToChain(double arc) const { return chain_from + (reversed ? to - arc : arc - from); }
};

struct TrueChains {
  std::vector<TrueChain> chains;
  std::vector<TrueNode> nodes;
  // Per polyline of the truth, ascending, without gaps. None for a polyline of no length.
  std::vector<std::vector<TruePiece>> pieces;
};

// Cuts the polylines of the truth where they turn by more than 40 degrees, where another one ends
// on them and at the truth's own nodes, and joins the pieces to chains. Two ends that are nearer
// than the tolerance are at one place; the chain continues there if there are exactly two, the turn
// is at most 40 degrees and the truth has no junction of its own there. A junction of the truth's
// own that has fewer arms than its degree also gets the nearest chains that end in nothing within
// 16 tolerances and face it within 20 degrees, in directions of their own: a truth of what images
// show has gaps there. `tolerance_at` is in world units. O(n log n) for tolerances of the size of
// the details.
TrueChains FindTrueChains(const CurveSet& truth,
                          const std::function<double(const Eigen::Vector3d&)>& tolerance_at);

// Where a sample is on its chain; chain = -1 on polylines of no length and on points.
struct ChainPlace {
  int chain = -1;
  double arc = 0;
};

// Per sample. `samples` are those of the truth that the chains are of.
std::vector<ChainPlace> PlacesOnChains(const TrueChains& chains, const CurveSamples& samples);

// Unit direction from an end of a polyline to the place `reach` further along it, or to its other
// end if that is nearer. Zero if the two coincide.
Eigen::Vector3d DirectionFromEnd(const Polyline3d& points, bool from_end, double reach);

}  // namespace limn
