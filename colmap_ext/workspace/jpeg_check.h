// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limn::colmap_ext {

// What the decoder finds wrong with a JPEG file whose header it can read.
struct JpegComplaint {
  std::string text;
  // The entropy-coded data are wrong. Where the damage begins is unknown: each code depends on
  // those before it, and the decoder accepts garbage until it meets an impossible code.
  bool is_damage = false;
  // It ends before the picture does. If only its end marker is missing, that is no damage.
  bool is_truncated = false;
};

// The first complaint, one of damage if there is any. Nothing for whole files, for files of other
// formats, and for padding at the end. Reads all codes of the file, but makes no pixels; zeros in
// place of codes are found where they cannot be codes of flat blocks. Throws IoError if the header
// cannot be read, and std::bad_alloc.
std::optional<JpegComplaint> CheckJpeg(const std::filesystem::path& path);

// Interleaved rows of RGB or one gray channel.
struct JpegPixels {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<unsigned char> data;
};

// Decodes a JPEG file at 1 / reduction (1, 2, 4 or 8) of its size: the pixels that OpenCV decodes,
// but without printing anything: CheckJpeg reports problems. Nothing for files of other formats,
// and for color spaces other than gray and those that convert to RGB. Throws IoError if the file
// cannot be decoded, and std::bad_alloc.
std::optional<JpegPixels> DecodeJpeg(const std::filesystem::path& path, int reduction);

}  // namespace limn::colmap_ext
