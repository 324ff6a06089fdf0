#pragma once

#include <filesystem>
#include <vector>

#include "limn/model/image.h"

namespace limn::colmap_ext {

struct ImageSize {
  int width = 0;
  int height = 0;

  bool operator==(const ImageSize&) const = default;
};

// The size after --max_image_size: unchanged if that is -1 or not exceeded by either side; else the
// longer side becomes max_image_size and the other is rounded.
ImageSize ShrunkSize(ImageSize size, int max_image_size);

// Size as stored (no EXIF rotation, which COLMAP ignores too), from the header. Throws IoError if
// the file is missing, truncated or of no known format.
ImageSize ReadImageSize(const std::filesystem::path& path);

// Throws IoError if decoding may take more than 2 GB: 6 bytes per pixel as stored (16 bits per
// channel, or a progressive JPEG file) and 12 per pixel of the result.
void CheckDecodable(const std::filesystem::path& path, ImageSize stored, int max_image_size);

// Decodes a photograph: 8 or 16 bits per channel, gray or color (alpha is dropped), EXIF rotation
// ignored; values in gray levels 0..255, color as RGB. Shrunk by an area filter to ShrunkSize; JPEG
// files of more than 16 megapixels are decoded at a half, a quarter or an eighth of their size if
// that is at least twice the size wanted. Throws IoError as ReadImageSize and CheckDecodable do,
// and if the file cannot be decoded or has another bit depth.
Image ReadImage(const std::filesystem::path& path, int max_image_size = -1);

// Decodes a mask and shrinks it likewise: nonzero where the file is nonzero in the whole area of a
// pixel. Throws IoError, also if the size of the mask is not `expected` (that of its photograph as
// stored).
std::vector<unsigned char> ReadMask(const std::filesystem::path& path, ImageSize expected,
                                    int max_image_size = -1);

}  // namespace limn::colmap_ext
