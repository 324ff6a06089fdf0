#pragma once

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

}  // namespace limn::colmap_ext
