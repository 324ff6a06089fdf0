// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "colmap_ext/model/model.h"

namespace limn::colmap_ext {

// The masks of images.
struct FoundMasks {
  std::vector<std::string> paths;  // per image; empty: it has none
  std::vector<std::string> warnings;
  std::vector<std::string> notes;
};

// Finds the masks of these images (indices into model.images, with their files) at `mask_path`:
//   a folder   <image name>.png, as in COLMAP. An image without that has the one picture that is
//              named as it is, with or without its extension, with any extension, and with or
//              without the word "mask" before or behind; in the same sub-folder, or anywhere below
//              if that is unambiguous. Photographs themselves are no masks.
//   a text     lines "<image name><tab><path of its mask>", as model_importer writes it
//   (masks.txt);
//              paths are relative to the folder of the text
//   a picture  the mask of all images
// Nothing if the path is empty. Images without a mask are counted in a warning. Throws IoError: no
// such path, a folder without a mask for any image, two masks for one image or one for two.
FoundMasks FindMasks(const std::string& mask_path, const SparseModel& model,
                     const std::vector<int>& images, const std::vector<std::string>& image_files);

// The list of masks that model_importer has written into the folder of a model; empty if there is
// none.
std::string MaskListOf(const std::filesystem::path& model_dir);
constexpr const char* kMaskList = "masks.txt";

// A folder beside that of the images which seems to hold masks; empty if there is none.
std::string MasksBeside(const std::filesystem::path& image_dir);

}  // namespace limn::colmap_ext
