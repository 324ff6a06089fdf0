// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>

#include "colmap_ext/workspace/image_size.h"

namespace limn::colmap_ext {

// A picture in a TIFF file, which may have several: pages, previews, those of a camera's raw file.
struct TiffDirectory {
  uint64_t offset = 0;  // in the file
  bool is_first = false;
  ImageSize size;
  int bits = 8;  // per channel
  bool has_alpha = false;
  int orientation = 1;              // 1 to 8, as of EXIF
  uint64_t orientation_offset = 0;  // of its value; 0: the file has none
  bool is_raw = false;              // values of single color sensors, which must be developed
};

// The largest picture of a TIFF or BigTIFF file; of several the first. Transparency masks are none.
// A raw picture counts only if all others are less than .9 as wide. Nothing for other formats and
// for damaged directories. Reads at most 64 directories.
std::optional<TiffDirectory> LargestTiffDirectory(std::istream& in);

// The orientation that the first directory of a TIFF file or of EXIF data has, 1 to 8; 1 if it has
// none.
int TiffOrientation(std::istream& in);

// The bytes of the same file, such that decoders, which take the first directory, find this one,
// upright.
std::string WithFirstDirectory(std::string bytes, const TiffDirectory& directory);

}  // namespace limn::colmap_ext
