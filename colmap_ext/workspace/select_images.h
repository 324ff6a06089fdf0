// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "colmap_ext/model/model.h"
#include "colmap_ext/model/scene_reach.h"
#include "colmap_ext/workspace/photo_store.h"
#include "limn/util/parallel.h"

namespace limn::colmap_ext {

// The images of a model to work on.
struct SelectedImages {
  SceneReach reach;  // of all that were asked for
  // Indices into model.images, sorted by name, and the files.
  std::vector<int> images;
  std::vector<std::string> paths;
  std::vector<std::string> warnings;
  std::vector<std::string> notes;  // what else the user should know
};

// Those in the list (ReadListedImages), or all without one; their files as FindImageFiles says.
// Images far outside the scene of the others (SceneReach) and duplicates (FindDuplicateImages) are
// left out with warnings; of duplicates, the one with the most 2D points stays. With
// `skip_missing`, so are images whose file does not exist. Throws IoError if a name in the list is
// not registered or a file is missing, InputError if no image is left.
SelectedImages SelectImages(const SparseModel& model, const std::filesystem::path& image_dir,
                            const std::string& image_list_path, bool skip_missing,
                            const PhotoStore& photos, const RunContext& context);

}  // namespace limn::colmap_ext
