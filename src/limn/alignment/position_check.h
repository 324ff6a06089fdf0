// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/alignment/position_fit.h"

namespace limn {

// Why positions contradict the cameras (algorithm/alignment.md#contradictions).
enum class PositionDoubt {
  kNone,
  kExchanged,   // latitude and longitude are exchanged
  kMirrored,    // their mirror image fits
  kStretched,   // they fit if stretched differently along three directions
  kAnyOrder,    // they fit no better than in another order
  kManyWrong,   // too many contradict the others
  kGravity,     // they have another up than measured gravity
  kUpsideDown,  // by them the photographs were taken upside down
  kLengths,     // they have another scale than known lengths
};

struct PositionCheck {
  PositionDoubt doubt = PositionDoubt::kNone;
  // For kExchanged, kMirrored and kStretched: the median residual of what fits, in the unit of the
  // target.
  double other_residual = 0;
  // For kStretched: how much longer than in the source, descending, by their mean.
  Eigen::Vector3d stretch = Eigen::Vector3d::Ones();
};

// Whether a fit of all pairs contradicts itself: another kind of map leaves far smaller residuals;
// the pairs fit no better than most fit in random orders, and by more than the `accuracy` (standard
// deviation along each axis, in the unit of scaled residuals; 0 = unknown) explains; or too many
// were rejected. `exchanged`, if not empty, are the same pairs with latitude and longitude
// exchanged. The same pairs give the same result. Time: that of 40 fits to up to 200 pairs.
PositionCheck CheckPositions(const std::vector<PointPair>& pairs, const PositionFit& fit,
                             const std::vector<PointPair>& exchanged, double accuracy);

}  // namespace limn
