// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// Of links with this evidence, hardly one is false where the cameras are right. Their share in the
// length of a drawing tells whether they are.
constexpr double kSureEvidence = 11;

// What is known of a judged link.
struct LinkFacts {
  double evidence = 0;
  size_t num_views = 0;  // that support it
  int num_free = 0;      // ends that meet nothing
  double tri_angle_deg = -1;
};

// Probability that a link is right: that the curve it draws exists within 2 px of it. `sure_share`
// is that of links with kSureEvidence in the length of all links that were judged; it is 0 where
// cameras belong to other images. Ours (algorithm/belief.md#confidence): a logistic regression on
// scenes with truth, and in proportion to the angle where views hardly measure depth.
double ConfidenceOf(const LinkFacts& facts, double sure_share);

// Sets the confidence of all links that have evidence but contours, which are another curve for
// every view, and that of rods, which is the one of being a rod; others get none. It is a tenth for
// unsure links whose edgels stand still. Needs angles (MeasureDepth). Linear time.
void TellConfidences(const std::vector<View>& views, DrawingGraph* graph);

}  // namespace limn
