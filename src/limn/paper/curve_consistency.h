// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/paper/local_consistency.h"

namespace limn {

// The stretch along which a curve runs beside another one.
struct CurveOverlap {
  int other = -1;  // curve
  // Per sample of the curve the corresponding sample of the other, -1 where there is none.
  std::vector<int> partner;
};

// The multiview curve-level consistency network (ECCV 2016, section 3; MCCN in the paper;
// algorithm/paper.md#curve-consistency-network). Curves with enough strong links between their
// samples are linked; their overlaps are regularized along the curve.
struct CurveConsistency {
  std::vector<std::vector<CurveOverlap>> overlaps;  // per curve, ascending by other
  int num_clusters = 0;                             // connected components
  std::vector<int> cluster_of;                      // per curve, named by one of its curves
};

CurveConsistency BuildCurveConsistency(const SampleSet& samples, const LocalConsistency& network,
                                       const PaperOptions& options, const RunContext& context);

// Closes gaps (runs of -1 with partners on both sides) up to this arc length, interpolating the
// partners, then removes runs of partners shorter than it or half the curve, whichever is less.
// Runs that touch an end of the curve are treated like any other.
void RegularizeOverlap(const std::vector<double>& arc, double regularity_px,
                       std::vector<int>* partner);

// The number of primary views, its own included, whose curves overlap a sample (its agreement,
// algorithm/paper.md#curve-consistency-network).
int CountAgreeingViews(const SampleSet& samples, const CurveConsistency& network, int sample);

}  // namespace limn
