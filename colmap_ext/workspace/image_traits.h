// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <istream>

namespace limn::colmap_ext {

// What the header of an image says beside its size.
struct ImageTraits {
  // How the picture must be turned to be upright, as EXIF numbers it: 1 not at all, 3 by 180
  // degrees, 6 and 8 by 90 clockwise and counterclockwise, others also mirrored.
  int orientation = 1;
  // More than 8 bits per channel.
  bool is_deep = false;
  // The format may hold an alpha channel, and the file has one.
  bool has_alpha = false;
};

// Of a JPEG, PNG, TIFF, WebP or JPEG 2000 file; the defaults for others and for what cannot be
// read.
ImageTraits ReadTraits(std::istream& in);
ImageTraits ReadTraits(const std::filesystem::path& path);

// Whether an image of this orientation is wide where its file is high.
inline bool SwapsSides(int orientation) { return orientation >= 5; }

}  // namespace limn::colmap_ext
