// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/paper/curve_consistency.h"

namespace limn {

struct AveragingResult {
  int rounds = 0;
  // In the last round no sample moved by more than averaging_tolerance_px.
  bool converged = false;
  double last_move_px = 0;  // of the sample that moved farthest in the last round
};

// Iterative averaging (ECCV 2016, section 3; algorithm/paper.md#averaging). In each round every
// sample moves to the plain average of its own position and the closest points of the curves that
// it overlaps, sought anew in each round; feet beyond the end of a curve are left out. All samples
// move at once, until none moves by more than averaging_tolerance_px or max_averaging_rounds have
// been made. A sample that moves by no more than the tolerance rests for good (as in the authors'
// program), since strands drift towards each other without end. Time: rounds times samples times
// partners.
AveragingResult AverageCurves(const CurveConsistency& network, const PaperOptions& options,
                              const RunContext& context, SampleSet* samples);

}  // namespace limn
