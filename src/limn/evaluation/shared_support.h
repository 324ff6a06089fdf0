// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// What two views have in common, by the curves that both may see.
struct SharedSupport {
  ViewId from = -1;
  ViewId to = -1;
  // Length of the links that `from` supports, where they are in the image of `to`.
  double promised_px = 0;
  // Of that, what `to` supports, too.
  double shared_px = 0;
  // Between the rays of the two views, mean over what is promised.
  double angle_deg = 0;
};

// Of all ordered pairs of views that promise something, ascending by `from`, then by `to`.
// Tentative links count, outlines and center lines do not (IsAlongEdgels), nor places that `to`
// sees coarser than `from` by a factor of more than 1.5. Of a large drawing some links and views
// stand for all. Time: at most 30,000 places, times 40 views that support them, times 40 that
// contain them.
std::vector<SharedSupport> MeasureSharedSupport(const std::vector<View>& views,
                                                const DrawingGraph& graph);

}  // namespace limn
