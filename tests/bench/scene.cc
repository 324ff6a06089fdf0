// SPDX-License-Identifier: BSD-3-Clause
#include "bench/scene.h"

#include <utility>

#include "limn/model/scene_subset.h"

namespace limn::bench {
namespace {

constexpr ViewId kHeldOutPeriod = 10;
constexpr ViewId kFirstHeldOut = 5;

}  // namespace

bool IsHeldOut(ViewId view) { return view % kHeldOutPeriod == kFirstHeldOut; }

Scene PartOf(const Scene& scene, bool held_out) {
  std::vector<ViewId> ids;
  Scene part;
  for (ViewId v = 0; v < static_cast<ViewId>(scene.views.size()); ++v) {
    if (IsHeldOut(v) != held_out) continue;
    ids.push_back(v);
    part.curves.push_back(scene.curves[v]);
  }
  SceneSubset subset = SubsetOf(scene.views, scene.hints, ids);
  part.views = std::move(subset.views);
  part.hints = std::move(subset.hints);
  return part;
}

}  // namespace limn::bench
