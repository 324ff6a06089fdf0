// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

#include "colmap_ext/workspace/image_form.h"
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
// (for alpha see ReadAlpha), turned and stretched as `form` says, by default as stored; values in
// gray levels 0..255, color as RGB. Shrunk by an area filter to ShrunkSize; JPEG files of more than
// 16 megapixels are decoded at a half, a quarter or an eighth of their size if that is at least
// twice the size wanted. Throws IoError as CheckDecodable does, and if the file cannot be decoded
// or has another bit depth.
Image ReadImage(const std::filesystem::path& path, int max_image_size = -1,
                const ImageForm& form = {});

// A decoded photograph.
struct PhotoPixels {
  ImageSize size;
  int channels = 1;  // gray, or 3: RGB
  // Interleaved rows: 8 or 16 bits, or 0 to 1.
  std::variant<std::vector<uint8_t>, std::vector<uint16_t>, std::vector<float>> values;
};

// The image that ReadImage would make from a file with these pixels.
Image ImageFromPixels(const PhotoPixels& pixels, int max_image_size = -1,
                      const ImageForm& form = {});

// What the pixels of a photograph say about their use.
struct PixelScan {
  // Of values of 16 bits: all but one in ten thousand at either end. Nothing if there are no such
  // values.
  std::optional<LevelRange> values;
  // Some pixels are less than half opaque, and some are not.
  bool has_mask = false;
};

// Decodes the file. Throws IoError as ReadImage does.
PixelScan ScanPixels(const std::filesystem::path& path);
PixelScan ScanPixels(const PhotoPixels& pixels);

// The range to show for files whose values lie in this one: rounded outward to an eighth of a power
// of two, so that more files of the same camera seldom change it. Nothing if they use half of the
// 16 bits or more, or if there is next to nothing to see.
std::optional<LevelRange> RangeToShow(const LevelRange& values);

// Decodes a mask of a photograph of the size `expected`, turned upright by `orientation`, and makes
// it as large as that becomes: nonzero where the file is nonzero in the whole area of a pixel. A
// pixel is zero if all of its colors are, or its alpha; of files with nothing but alpha that alone
// counts, and of JPEG, WebP and JPEG 2000 files, which blur, less than half of the largest value.
// The mask may be larger or smaller than the photograph if the aspect is the same, and turned as
// its file is. Throws IoError, also if its size does not fit.
std::vector<unsigned char> ReadMask(const std::filesystem::path& path, ImageSize expected,
                                    int max_image_size = -1, int orientation = 1);

// The alpha channel of a photograph as a mask, likewise: nonzero where it is at least half opaque.
// Throws IoError, also if there is none.
std::vector<unsigned char> ReadAlpha(const std::filesystem::path& path, int max_image_size,
                                     const ImageForm& form);

}  // namespace limn::colmap_ext
