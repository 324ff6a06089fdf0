// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "colmap_ext/workspace/image_size.h"

namespace limn::colmap_ext {

// Values of 16 bits that are shown as gray levels 0 and 255, where a file uses a part of its range
// only.
struct LevelRange {
  double low = 0;
  double high = 65535;

  bool operator==(const LevelRange&) const = default;
};

// How the pixels of a file become a photograph: what its camera and the other files tell beside its
// header. The defaults: as stored.
struct ImageForm {
  int orientation = 1;  // how it is turned, as EXIF numbers it (ImageTraits)
  std::optional<LevelRange> range = std::nullopt;
  bool has_mask = false;  // the alpha channel: where it is less than half opaque nothing is used

  bool operator==(const ImageForm&) const = default;
};

// The size after turning.
inline ImageSize Turned(ImageSize size, int orientation) {
  return orientation >= 5 ? ImageSize{size.height, size.width} : size;
}

// Part of the key of cached results; empty for the defaults.
std::string KeyOf(const ImageForm& form);

}  // namespace limn::colmap_ext
