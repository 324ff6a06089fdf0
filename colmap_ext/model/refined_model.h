// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "colmap_ext/model/model.h"
#include "limn/model/scene_hints.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// Applies refined cameras and points, in the model's coordinates, to the model that they were made
// from: poses of images with a view, parameters of cameras, positions of points. The errors of the
// points become unknown. Throws IoError, and changes nothing, if this is another model. Rigs and
// frames are left as they are. Of a panorama the first part counts.
void ApplyRefinement(const std::vector<View>& views, const SceneHints& hints, SparseModel* model);

}  // namespace limn::colmap_ext
