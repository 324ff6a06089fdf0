// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace limn {

// How many of the views that contain a sample must support it
// (algorithm/notation.md#required-views): a share of them, since a fixed number cannot suit both 8
// and 1,000 views, but at least min_views and at most max_views.
inline int NumRequiredViews(int num_containing, double share, int min_views, int max_views) {
  return std::clamp(static_cast<int>(std::lround(share * num_containing)), min_views, max_views);
}

}  // namespace limn
