#pragma once

#include <vector>

#include "limn/drawing/local_consistency.h"

namespace limn {

// Where a curve runs along another one.
struct CurveOverlap {
  int other = -1;  // curve
  // Per sample of the curve the corresponding sample of the other, -1 where there is none.
  std::vector<int> partner;
};

// The multiview curve-level consistency network (ECCV 2016, section 4; MCCN in the paper): curves
// with enough strong links between their samples are linked; their overlaps are regularized along
// the curve.
struct CurveConsistency {
  std::vector<std::vector<CurveOverlap>> overlaps;  // per curve, ascending by other
  // Connected component of every curve: the smallest curve in it.
  std::vector<int> cluster;
};

CurveConsistency BuildCurveConsistency(const SampleSet& samples, const LocalConsistency& network,
                                       const DrawingOptions& options, const RunContext& context);

// Close gaps (runs of -1 with partners on both sides) up to max_gap of arc length, interpolating
// the partners, then remove runs of partners shorter than min_run. Runs that touch an end of the
// curve are judged like any other; min_run is halved for curves shorter than twice it.
void RegularizeOverlap(const std::vector<double>& arc, double max_gap, double min_run,
                       std::vector<int>* partner);

// Number of different primary views, its own included, whose curves agree with a sample.
std::vector<int> CountAgreeingViews(const SampleSet& samples, const CurveConsistency& network);

}  // namespace limn
