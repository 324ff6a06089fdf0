// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace limn::colmap_ext {

struct ImageSize {
  int width = 0;
  int height = 0;

  int64_t NumPixels() const { return int64_t{width} * height; }
  bool operator==(const ImageSize&) const = default;
};

// For messages.
inline std::string Text(ImageSize size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

// Whether an image file may be a resized version of a picture of this size: one aspect, up to a
// pixel of either.
inline bool IsResized(ImageSize file, double width, double height) {
  return std::min(std::abs(file.width * height / width - file.height),
                  std::abs(file.height * width / height - file.width)) <= 1;
}

}  // namespace limn::colmap_ext
