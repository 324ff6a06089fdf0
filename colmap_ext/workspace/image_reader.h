#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

#include "colmap_ext/workspace/image_size.h"
#include "colmap_ext/workspace/jpeg_check.h"
#include "limn/model/image.h"

namespace limn::colmap_ext {

// The size after --max_image_size: unchanged if that is -1 or not exceeded by either side; else the
// longer side becomes max_image_size and the other is rounded.
ImageSize ShrunkSize(ImageSize size, int max_image_size);

// Size as stored (no EXIF rotation, which COLMAP ignores too), from the header. Throws IoError if
// the file is missing, truncated or of no known format.
ImageSize ReadImageSize(const std::filesystem::path& path);

// Throws IoError if decoding may take more than 2 GB: 6 bytes per pixel as stored and 12 per pixel
// of the result, and before that 8 bytes per pixel as stored of a WebP file, 18 of a TIFF file and
// 30 of a JPEG 2000 file.
void CheckDecodable(const std::filesystem::path& path, ImageSize stored, int max_image_size);

struct CheckedImage {
  ImageSize size;  // as stored
  std::optional<JpegComplaint> complaint;
};

// Everything that is checked before a photograph is used; reads the whole file. Throws IoError as
// ReadImageSize, CheckDecodable and CheckJpeg do, and if it does not fit in memory.
CheckedImage CheckImage(const std::filesystem::path& path, int max_image_size);

// Decodes a photograph that CheckImage has found whole: 8 or 16 bits per channel, gray or color
// (alpha is dropped), EXIF rotation ignored; values in gray levels 0..255, color as RGB. Shrunk by
// an area filter to ShrunkSize; JPEG files of more than 16 megapixels are decoded at a half, a
// quarter or an eighth of their size if that is at least twice the size wanted. Throws IoError as
// CheckDecodable does, and if the file cannot be decoded or has another bit depth.
Image ReadImage(const std::filesystem::path& path, int max_image_size = -1);

// A decoded photograph.
struct PhotoPixels {
  ImageSize size;
  int channels = 1;  // gray, or 3: RGB
  // Interleaved rows: 8 or 16 bits, or 0 to 1.
  std::variant<std::vector<uint8_t>, std::vector<uint16_t>, std::vector<float>> values;
};

// The image that ReadImage would make from a file with these pixels.
Image ImageFromPixels(const PhotoPixels& pixels, int max_image_size = -1);

// Decodes a mask and shrinks it likewise: nonzero where the file is nonzero in the whole area of a
// pixel. Throws IoError, also if the size of the mask is not `expected` (that of its photograph as
// stored).
std::vector<unsigned char> ReadMask(const std::filesystem::path& path, ImageSize expected,
                                    int max_image_size = -1);

}  // namespace limn::colmap_ext
