// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "limn/files/output_path.h"

namespace limn::colmap_ext {

// The masks of images, by the names of these.
using ImageMasks = std::map<std::string, std::string>;

// Writes the list of masks (kMaskList of find_masks.h) of a model into a folder that will become
// `model_dir`, with paths relative to that. Throws IoError, also for names that a line of the list
// cannot hold.
void WriteMaskList(const ImageMasks& masks, const std::filesystem::path& model_dir,
                   const OutputPath& folder);

}  // namespace limn::colmap_ext
