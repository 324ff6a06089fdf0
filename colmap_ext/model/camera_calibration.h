// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/model/camera_model.h"
#include "limn/model/calibration.h"

namespace limn::colmap_ext {

// The optics of a COLMAP camera for images of this size, which are those of the camera resized.
// Precondition: not EQUIRECTANGULAR.
Optics MakeOptics(const Camera& camera, int width, int height);

}  // namespace limn::colmap_ext
