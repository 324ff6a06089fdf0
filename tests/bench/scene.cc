// SPDX-License-Identifier: BSD-3-Clause
#include "bench/scene.h"

namespace limn::bench {
namespace {

constexpr ViewId kHeldOutPeriod = 10;
constexpr ViewId kFirstHeldOut = 5;

}  // namespace

bool IsHeldOut(ViewId view) { return view % kHeldOutPeriod == kFirstHeldOut; }

Scene PartOf(const Scene& scene, bool held_out) {
  Scene part;
  for (ViewId v = 0; v < static_cast<ViewId>(scene.views.size()); ++v) {
    if (IsHeldOut(v) != held_out) continue;
    part.views.push_back(scene.views[v]);
    part.curves.push_back(scene.curves[v]);
  }
  return part;
}

}  // namespace limn::bench
