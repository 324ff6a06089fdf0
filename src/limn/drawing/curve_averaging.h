#pragma once

#include "limn/drawing/curve_consistency.h"

namespace limn {

// Iterative robust averaging (ECCV 2016, section 5): every sample moves to the average of its own
// position and the closest points of the curves it overlaps, each weighted by its inverse
// covariance across the curve, those further off than the merge gate left out; all at once in each
// round, until no sample moves by more than the tolerance. Feet beyond the end of a curve do not
// pull. Returns the rounds made. Time: rounds x overlaps.
int AverageCurves(const CurveConsistency& network, const DrawingOptions& options,
                  const RunContext& context, SampleSet* samples);

}  // namespace limn
