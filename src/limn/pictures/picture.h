// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "limn/files/output_path.h"

namespace limn {

// An 8-bit RGB picture, rows from the top, interleaved.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<uint8_t> rgb;

  const uint8_t* At(int x, int y) const { return &rgb[3 * (static_cast<size_t>(y) * width + x)]; }
};

// Writes a PNG atomically and creates missing folders (image names may contain folders). It begins
// with kPngOfLimn after its header. Throws IoError.
void WritePng(const OutputPath& path, const Picture& picture);

// The kind and content of the chunk that tells who made a picture.
constexpr std::string_view kPngOfLimn("tEXtSoftware\0limn", 17);

// "sub/a.jpg" under "overlays" is "overlays/sub/a.jpg.png": two photographs never share a picture,
// even if their names differ only in the extension.
OutputPath PicturePath(const OutputPath& folder, const std::string& image_name);

}  // namespace limn
