#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "colmap_ext/import/import_input.h"

namespace limn::colmap_ext {

// Which image each of several camera files belongs to.
struct FileMatches {
  // Per file the name of its image, to be given to ImageFolder::Find; an empty string if there is
  // none and missing images are skipped.
  std::vector<std::string> names;
  // The rule that was used, in words.
  std::string note;
};

// Match camera files, one per image and in natural order, to the images of input.images. The rule
// is the first of these that applies:
//   list     a list of images is given: its k-th line is the image of the k-th file
//   name     some file has an image of its name (without extensions): so must all
//   number   some file has an image with the same last number in its name (001.projmatrix and
//            midday-640x-0001.png); no number may occur twice on either side
//   order    there are as many images as files: the k-th goes with the k-th, both in natural order
// Images without a file are left out. Throws IoError if no rule applies or a file finds no image;
// a file without an image is left out if missing images are to be skipped.
FileMatches MatchFilesToImages(const std::vector<std::filesystem::path>& files,
                               const ImportInput& input);

}  // namespace limn::colmap_ext
