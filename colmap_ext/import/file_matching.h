// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "colmap_ext/import/import_input.h"

namespace limn::colmap_ext {

// The image that each camera file belongs to.
struct FileMatches {
  // Per file the name of its image, for ImageFolder::Find; empty if it has none and missing images
  // are skipped.
  std::vector<std::string> names;
  // The rule that was used, for the user.
  std::string note;
};

// Matches camera files, one per image and in natural order, to the images of input.images, by the
// first of these rules that applies:
//   list     a list of images is given: line k names the image of file k
//   name     some file and some image have the same name without extension: then all must
//   number   some file and some image have the same last number in their names (001.projmatrix and
//            midday-640x-0001.png); no number may occur twice on either side
//   order    there are as many images as files: file k goes with image k, both in natural order
// Images without a file are ignored. Throws IoError if no rule applies, or if a file has no image
// and missing images are not skipped.
FileMatches MatchFilesToImages(const std::vector<std::filesystem::path>& files,
                               const ImportInput& input);

// The scene of camera files, one per image, matched as above. `read` sets camera and pose of an
// image of this size from the file at its path. Throws IoError.
ImportedScene ReadCameraFiles(
    const std::vector<std::filesystem::path>& files, const ImportInput& input,
    const std::function<void(const ImageSize& size, ImportedImage* image)>& read);

}  // namespace limn::colmap_ext
