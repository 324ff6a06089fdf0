// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace limn::colmap_ext {

// The bytes of a JPEG file with EXIF data behind its first marker, whose only entry is an
// orientation (6: a turn by 90 degrees).
inline std::string WithOrientation(const std::string& jpeg, char orientation) {
  std::string exif(
      "\xFF\xE1\x00\x22"
      "Exif\0\0"
      "II\x2A\0\x08\0\0\0"
      "\x01\0"
      "\x12\x01\x03\0\x01\0\0\0\x06\0\0\0"
      "\0\0\0\0",
      36);
  exif[exif.size() - 8] = orientation;
  return jpeg.substr(0, 2) + exif + jpeg.substr(2);
}

}  // namespace limn::colmap_ext
