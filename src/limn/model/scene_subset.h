// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/scene_hints.h"
#include "limn/model/view.h"

namespace limn {

// A subset of the views of a scene, as a scene of its own.
struct SceneSubset {
  std::vector<ViewId> ids;  // per view, in the whole scene
  std::vector<View> views;
  SceneHints hints;  // restricted to these views
};

// `ids` must be ascending. Linear in the size of the hints.
SceneSubset SubsetOf(const std::vector<View>& views, const SceneHints& hints,
                     const std::vector<ViewId>& ids);

}  // namespace limn
