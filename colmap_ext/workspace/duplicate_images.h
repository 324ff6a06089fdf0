// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "colmap_ext/model/model.h"
#include "colmap_ext/workspace/photo_store.h"
#include "limn/util/parallel.h"

namespace limn::colmap_ext {

// Positions in the list of images.
struct DuplicateImage {
  int duplicate = 0;
  int of = 0;  // comes before it, and is not a duplicate itself
};

// Images that add nothing, ascending: files with the same bytes, pictures that are nearly the same
// (by two gray levels on average, when small) from nearly the same pose (by a quarter of a pixel at
// the median depth of the points that are seen), and copies, which are not displaced although their
// poses are, by up to two pixels. `images` are indices into model.images, `paths` their files.
// Files of equal size are read, pictures of poses alike decoded, for copies up to eight large ones
// per image. Poses are compared with those whose centers are near along the longest axis of the
// scene: n log n, and n^2 where all are near to each other. Throws IoError.
std::vector<DuplicateImage> FindDuplicateImages(const SparseModel& model,
                                                const std::vector<int>& images,
                                                const std::vector<std::string>& paths,
                                                const RunContext& context,
                                                const PhotoStore& photos = {});

}  // namespace limn::colmap_ext
