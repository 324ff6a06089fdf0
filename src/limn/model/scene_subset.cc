// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/scene_subset.h"

#include <utility>

namespace limn {

SceneSubset SubsetOf(const std::vector<View>& views, const SceneHints& hints,
                     const std::vector<ViewId>& ids) {
  SceneSubset subset;
  subset.ids = ids;
  std::vector<ViewId> new_id(views.size(), -1);
  for (const ViewId id : ids) {
    new_id[id] = static_cast<ViewId>(subset.views.size());
    subset.views.push_back(views[id]);
  }
  for (const ScenePoint& point : hints.points) {
    ScenePoint kept{point.position_in_world, {}, {}, point.model_index};
    for (const ViewId view : point.views) {
      if (new_id[view] >= 0) kept.views.push_back(new_id[view]);
    }
    if (kept.views.empty()) continue;
    for (const PointPixel& pixel : point.pixels) {
      if (new_id[pixel.view] < 0) continue;
      kept.pixels.push_back(pixel);
      kept.pixels.back().view = new_id[pixel.view];
    }
    subset.hints.points.push_back(std::move(kept));
  }
  return subset;
}

}  // namespace limn
