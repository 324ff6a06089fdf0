// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

namespace limn {

// How single features of the truth are drawn, at one tau. Only those inside the region count.
// Lengths are in the unit of tau unless stated.

// Circles of the truth whose radius is from `from` to below `to`: closed polylines whose points lie
// within 1 % of their mean radius of a circle. A link or curve covers a sample of the circle if it
// is within tau and parallel within 20 degrees.
struct CircleScores {
  double from = 0;
  double to = 0;  // may be infinite
  int num_circles = 0;
  double covered = 0;     // mean share of a circle
  int num_one_curve = 0;  // one curve (CurveSet::curves) covers more than 90 %
  int num_closed = 0;     // a link that returns to its first point does
  // Such a link is of the type circle. Absent: links have no types.
  std::optional<int> num_of_type_circle;
};

// Of the true junctions of one kind, those with a node within junction_taus.
struct JunctionKindScores {
  int num_junctions = 0;
  // Of degree 3 or more, or, at a corner of two curves, of degree 2, which a closed curve has where
  // it begins.
  int num_found = 0;
  int num_with_4 = 0;  // of degree 4 or more
};

// True curves that have another one alongside from `from` to below `to` away. A place on one is
// found if the nearest parallel curve of the reconstruction is within tau of it and nearer to this
// true curve than to the other: one line in place of both is at most one of them.
struct PairScores {
  double from = 0;
  double to = 0;
  double true_length = 0;  // world units
  std::optional<double> recall;
};

// Corners with two or more arms that are drawn near them, and the pairs of these (meetings); see
// ScoreConnectivity. Corners are the true junctions of that kind; if the truth has no kinds, all
// places where its curves meet.
struct CornerScores {
  int num_drawn = 0;
  int num_open = 0;  // with a pair that is not joined
  int num_meetings = 0;
  int num_open_meetings = 0;
  // Although both arms have a link that ends within 3 footprints of the corner. Absent in world
  // units.
  std::optional<int> num_open_near;
};

// Rods by their center lines. A drawn rod and a true one match where they are within tau of each
// other and parallel within 20 degrees; don't-care curves forgive no rod.
struct RodScores {
  double true_length = 0;   // world units
  double drawn_length = 0;  // of drawn rods, world units
  // Share of the true length that a drawn rod matches: what is told as rods.
  std::optional<double> recall;
  // Length of all links, rods or not, that run within radius + tau of a true center line and
  // parallel within 20 degrees, per true length: 1 is best, 2 are both outlines. The radius is the
  // true one, or else that of the thickest drawn rod that matches there. Where neither is known
  // nothing counts: outlines cannot be told from what is beside the rod.
  std::optional<double> links_per_length;
  // Length of drawn rods that match no true one, per true length.
  std::optional<double> false_per_length;
  // Of drawn rods where they match: medians over length of the distance from the true center line,
  // in the unit of tau, and of the radius over the true one where that is known.
  std::optional<double> median_error, median_radius_ratio;
};

struct FeatureScores {
  std::vector<CircleScores> circles;  // only radii that occur
  JunctionKindScores corners, tees, crossings;
  std::vector<PairScores> pairs;  // none in world units
  CornerScores drawn_corners;
  // Filled in by callers that have true rods (rod_scores.h).
  std::optional<RodScores> rods;
};

}  // namespace limn
