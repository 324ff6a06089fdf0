#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace limn {

// An 8-bit RGB picture, rows from the top, interleaved.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<uint8_t> rgb;

  const uint8_t* At(int x, int y) const { return &rgb[3 * (static_cast<size_t>(y) * width + x)]; }
};

// Writes a PNG atomically and creates missing folders (image names may contain folders). Throws
// IoError.
void WritePng(const std::string& path, const Picture& picture);

// "sub/a.jpg" under "overlays" is "overlays/sub/a.jpg.png": two photographs never share a picture,
// even if their names differ only in the extension.
std::string PicturePath(const std::string& folder, const std::string& image_name);

}  // namespace limn
