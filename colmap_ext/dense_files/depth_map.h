// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <istream>
#include <ostream>
#include <string>
#include <vector>

#include "limn/files/output_path.h"

namespace limn::colmap_ext {

// A .bin array of COLMAP: a depth map (1 channel: depth along the optical axis, <= 0 = unknown) or
// a normal map (3 channels: unit normal in the camera frame). May be smaller than the image.
// COLMAP's ray of a pixel is K^-1 (column, row, 1), without a shift by half a pixel.
struct FloatMap {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<float> data;  // plane by plane, rows in order

  float At(int column, int row, int channel = 0) const {
    return data[(static_cast<size_t>(channel) * height + row) * width + column];
  }
};

// "W&H&C&" in ASCII, then little-endian floats. The streams must be seekable. Throws IoError: bad
// header, sides above 10^6, too few or too many data.
FloatMap ReadFloatMap(std::istream& in, const std::string& path);
FloatMap ReadFloatMap(const std::filesystem::path& path);

// Throws IoError if the file cannot be written.
void WriteFloatMap(const FloatMap& map, std::ostream& out);
void WriteFloatMap(const FloatMap& map, const OutputPath& path);

// Throw IoError unless the file has 1 channel, or 3 channels.
FloatMap ReadDepthMap(const std::filesystem::path& path);
FloatMap ReadNormalMap(const std::filesystem::path& path);

}  // namespace limn::colmap_ext
