#pragma once

#include "limn/drawing/curve_consistency.h"

namespace limn {

struct AveragingResult {
  int rounds = 0;
  // In the last round no sample moved by more than averaging_tolerance_px.
  bool converged = false;
  double last_move_px = 0;  // of the sample that moved farthest in the last round
};

// Iterative robust averaging (ECCV 2016, section 3; ALGORITHM.md 10). In each round every sample
// moves to the average of its own position and the closest points of the curves it overlaps,
// weighted by their inverse covariances across the curve. Points beyond the merge gate and feet
// beyond the end of a curve are left out. With the method "paper" it is the plain average of its
// position and the closest points of all of them, sought anew in each round; only feet beyond ends
// are left out, and a sample that moves by no more than the tolerance rests for good (as in the
// authors' program), since strands drift towards each other without end. All samples move at once,
// until none moves by more than averaging_tolerance_px or max_averaging_rounds have been made.
// Time: rounds times samples times partners, at most 12 of them unless with "paper".
AveragingResult AverageCurves(const CurveConsistency& network, const DrawingOptions& options,
                              const RunContext& context, SampleSet* samples);

}  // namespace limn
