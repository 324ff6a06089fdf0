// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/model/model.h"
#include "limn/geometry/similarity3.h"

namespace limn::colmap_ext {

// Moves a model by a similarity: poses of images and frames, places of sensors on their rigs, 3D
// points. The cameras see the same pixels as before; all else stays.
void TransformModel(const Similarity3d& b_from_a, SparseModel* model);

}  // namespace limn::colmap_ext
