// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "colmap_ext/model/model.h"
#include "colmap_ext/workspace/view_set.h"

namespace limn::colmap_ext {

// Holds the cameras of the images in a list (ViewOptions::hold_images), with all images that move
// together with them: CameraMounts::held of the set's mounts. Warns of images that are not in use.
// Throws IoError if the list cannot be read, OptionError if it is empty or an image is not
// registered.
void HoldImages(const SparseModel& model, const std::string& list_path, ViewSet* set);

}  // namespace limn::colmap_ext
