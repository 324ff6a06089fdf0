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

// Size as stored (no EXIF rotation, which COLMAP ignores too). JPEG and PNG headers are parsed,
// other formats decoded. Throws IoError.
ImageSize ReadImageSize(const std::filesystem::path& path);

// The size after --max_image_size: unchanged if that is -1 or not exceeded by either side; else the
// longer side becomes max_image_size and the other is rounded.
ImageSize ShrunkSize(ImageSize size, int max_image_size);

// Throws IoError if the image is too large to decode: more than 160 megapixels as decoded, or 640
// as stored. JPEG files of more than 16 megapixels are decoded at a half, a quarter or an eighth of
// their size if that is at least twice the size wanted; others whole.
void CheckDecodable(const std::filesystem::path& path, ImageSize stored, int max_image_size);

// Decodes a photograph: 8 or 16 bits per channel, gray or color (alpha is dropped), EXIF rotation
// ignored; values in gray levels 0..255, color as RGB. Shrunk by an area filter to ShrunkSize.
// Throws IoError if the file is missing, too large, cannot be decoded, or has another bit depth.
Image ReadImage(const std::filesystem::path& path, int max_image_size = -1);

// Decodes a mask and shrinks it likewise: nonzero where the file is nonzero in the whole area of a
// pixel. Throws IoError, also if the size of the mask is not `expected` (that of its photograph as
// stored).
std::vector<unsigned char> ReadMask(const std::filesystem::path& path, ImageSize expected,
                                    int max_image_size = -1);

}  // namespace limn::colmap_ext
