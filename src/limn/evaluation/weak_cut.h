// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "limn/evaluation/shared_support.h"

namespace limn {

// Two groups of views whose cameras do not fit each other, as two halves of a scene do of which one
// is turned: each has its own curves.
struct WeakCut {
  std::vector<ViewId> smaller;  // the views of the smaller group, ascending
  // What a view of one group shares with those of the other, over what it would share with them if
  // they were of its own group.
  double shared = 1;
  // Of the variance of what views share that neither the views themselves nor the angles between
  // them explain, the part that the cut explains.
  double explained = 0;
};

// Looks for the cut of the graph whose nodes are views and whose weights are what pairs of views
// share, compared with what others share under such an angle (algorithm/evaluation.md#weak-cut;
// ours). Nothing if no cut is weak enough for a warning, and for fewer than eight views. `pairs` as
// MeasureSharedSupport returns them. Time: some 500 times the number of pairs.
std::optional<WeakCut> FindWeakCut(int num_views, const std::vector<SharedSupport>& pairs);

}  // namespace limn
