// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "limn/evaluation/structure_scores.h"

namespace limn {

// The correct length of one curve, and its whole length.
struct CurveShare {
  double right = 0;
  double total = 0;
};

struct ShareIntervals {
  std::optional<Interval> precision, recall, f;
};

// 95 % confidence intervals of precision, recall and their harmonic mean, by 500 resamples with
// replacement of the links and, independently, of the true curves. A share of fewer than two curves
// of positive total has none. The same curves always give the same intervals.
// O(number of curves) per resample.
ShareIntervals BootstrapShares(const std::vector<CurveShare>& links,
                               const std::vector<CurveShare>& true_curves);

}  // namespace limn
