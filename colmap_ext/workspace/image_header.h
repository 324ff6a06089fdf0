// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <istream>
#include <optional>

#include "colmap_ext/workspace/image_size.h"

namespace limn::colmap_ext {

// Size from the header of a PNG, JPEG, TIFF, BMP, WebP, JPEG 2000, PNM or Sun raster file, without
// decoding it. Nothing for other formats, damaged headers and unreadable files.
std::optional<ImageSize> ReadSizeFromHeader(std::istream& in);
std::optional<ImageSize> ReadSizeFromHeader(const std::filesystem::path& path);

// The formats whose decoders have different needs.
enum class ImageFormat { kJpeg, kJpeg2000, kTiff, kWebp, kOther };

// By the first two bytes.
ImageFormat FormatOf(const std::filesystem::path& path);

// Whether a PNG or JPEG file is truncated: no IEND chunk, or no end-of-image marker after the first
// scan. Decoders would fill the missing part with gray. False for other formats.
bool IsTruncated(std::istream& in);
bool IsTruncated(const std::filesystem::path& path);

}  // namespace limn::colmap_ext
