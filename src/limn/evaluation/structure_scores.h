// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace limn {

// How the curves of a reconstruction are cut and joined, against a truth of curves, at one tau.
// Absent: the truth or the reconstruction has no curves, or the total of a share is zero. Only what
// is inside the region counts; free ends and junctions near don't-care curves do not.
struct StructureScores {
  // Mean number of links on a true chain (true_chains.h), weighted by its length, over the chains
  // of at least chain_taus that have any. A link is on a chain if it covers cover_taus of it: its
  // samples within tau of the chain, in the chain's direction and nearer to it than to others.
  std::optional<double> links_per_chain;
  // The same for curves, whose links together cover the chain (CurveSet::curves).
  std::optional<double> curves_per_chain;
  int num_chains = 0;        // of that length
  int num_drawn_chains = 0;  // with a link
  // Nodes of degree 1, and those among them that are farther than junction_taus from every true
  // end, corner and junction; the latter also per true length in world units.
  std::optional<int> num_free_ends, num_false_ends;
  std::optional<double> false_ends_per_length;
  // Junctions farther than junction_taus from every true junction.
  std::optional<int> num_false_junctions;
  std::optional<double> false_junctions_per_length;
  // True junctions and junctions within junction_taus of each other, matched one to one; the share
  // of them that have equal degrees.
  int num_matched_junctions = 0;
  std::optional<double> right_degrees;
  // Directions in which curves leave matched junctions: the shares of drawn ones and of true ones
  // that are matched one to one.
  std::optional<double> arm_precision, arm_recall;
  // Of the pairs of arms that meet at a true corner or junction and are both drawn near it: the
  // share that is joined there.
  std::optional<double> connectivity;
  int num_drawn_meetings = 0;
};

// Bounds of a confidence interval.
struct Interval {
  double low = 0;
  double high = 0;
};

}  // namespace limn
