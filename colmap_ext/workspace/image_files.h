// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "colmap_ext/model/model.h"
#include "colmap_ext/workspace/photo_store.h"

namespace limn::colmap_ext {

// Where the photographs of a model are.
struct ImageFiles {
  std::vector<std::string> paths;  // per image of the model; may not exist
  std::vector<std::string> notes;  // for the user: what was found under other names
};

// The files of these images (indices into model.images): those with the bytes of their names; else
// the same without a first folder that is called as the folder of images; else those with the same
// name in other bytes (MatchNames), for which the folder is listed. Paths of
// other images are empty. Throws IoError if two files fit a name equally well.
ImageFiles FindImageFiles(const SparseModel& model, const std::vector<int>& images,
                          const std::filesystem::path& image_dir, const PhotoStore& photos);

}  // namespace limn::colmap_ext
