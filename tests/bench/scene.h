// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/curve_fragment.h"
#include "limn/model/scene_hints.h"
#include "limn/model/view.h"

namespace limn::bench {

// Views and the curves of their images: what reconstructions are made from.
struct Scene {
  std::vector<View> views;
  std::vector<ImageCurves> curves;
  SceneHints hints;
};

// One view in ten is held out, from the sixth on: neither the first nor the last of a path.
bool IsHeldOut(ViewId view);

// The views whose IsHeldOut is `held_out`, renumbered, without hints.
Scene PartOf(const Scene& scene, bool held_out);

}  // namespace limn::bench
