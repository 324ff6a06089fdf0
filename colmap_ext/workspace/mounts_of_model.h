// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/model/model.h"
#include "colmap_ext/workspace/view_set.h"
#include "limn/cameras/camera_mounts.h"

namespace limn::colmap_ext {

// Images that move together: those of a frame of a rig. Parts of a panorama, too.
CameraMounts MountsOf(const SparseModel& model, const ViewSet& set);

}  // namespace limn::colmap_ext
