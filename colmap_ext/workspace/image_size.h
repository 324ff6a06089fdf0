#pragma once

#include <cstdint>

namespace limn::colmap_ext {

struct ImageSize {
  int width = 0;
  int height = 0;

  int64_t NumPixels() const { return int64_t{width} * height; }
  bool operator==(const ImageSize&) const = default;
};

}  // namespace limn::colmap_ext
