#include "colmap_ext/workspace/image_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <system_error>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "colmap_ext/workspace/image_header.h"
#include "colmap_ext/workspace/quiet_decoders.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// Larger JPEG images are decoded reduced where possible.
constexpr int64_t kAlwaysWholePixels = 16'000'000;
// With its 15 bytes per pixel of color while it is shrunk, 2.4 GB.
constexpr int64_t kMaxDecodedPixels = 160'000'000;
// A progressive JPEG file is in memory before it can be reduced, at up to 6 bytes per pixel.
constexpr int64_t kMaxStoredPixels = 640'000'000;

int64_t NumPixels(ImageSize size) { return int64_t{size.width} * size.height; }
int LongerSide(ImageSize size) { return std::max(size.width, size.height); }

void CheckWhole(const fs::path& path) {
  if (!IsTruncated(path)) return;
  throw IoError(path.string(), "truncated: the file ends before the picture does");
}

// Of JPEG files, whose decoder reduces by powers of two: 1, 2, 4 or 8, so that a large image is
// still at least twice as large as wanted, and an area filter has the last word.
int ReductionOf(const fs::path& path, ImageSize stored, int max_image_size) {
  const int wanted = LongerSide(ShrunkSize(stored, max_image_size));
  if (NumPixels(stored) <= kAlwaysWholePixels || !IsJpeg(path)) return 1;
  int reduction = 1;
  while (reduction < 8 && LongerSide(stored) >= 4 * reduction * wanted) reduction *= 2;
  return reduction;
}

// OpenCV's flags: IMREAD_REDUCED_GRAYSCALE_2 = 16 and so on also reduce color, with others.
int ReductionFlag(int reduction) { return reduction == 1 ? 0 : 8 * reduction; }

cv::Mat Decode(const fs::path& path, int flags) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) throw IoError(path.string(), "no such image file");
  CheckWhole(path);
  cv::Mat image;
  try {
    const QuietDecoders quiet;
    image = cv::imread(path.string(), flags | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception& error) {
    throw IoError(path.string(), "cannot be decoded: " + error.err);
  }
  if (image.empty()) throw IoError(path.string(), "cannot be decoded as an image");
  return image;
}

cv::Mat Shrink(const cv::Mat& image, int max_image_size) {
  const ImageSize size = ShrunkSize({image.cols, image.rows}, max_image_size);
  if (size == ImageSize{image.cols, image.rows}) return image;
  cv::Mat shrunk;
  cv::resize(image, shrunk, {size.width, size.height}, 0, 0, cv::INTER_AREA);
  return shrunk;
}

// The same for an image that was decoded reduced. Its last column and row may reach beyond the
// stored image; the factors are those of the stored image all the same.
cv::Mat ShrinkReduced(const cv::Mat& image, ImageSize stored, int reduction, int max_image_size) {
  const ImageSize size = ShrunkSize(stored, max_image_size);
  cv::Mat shrunk;
  cv::resize(image, shrunk, {}, static_cast<double>(size.width) * reduction / stored.width,
             static_cast<double>(size.height) * reduction / stored.height, cv::INTER_AREA);
  return shrunk;
}

std::string Text(ImageSize size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

}  // namespace

ImageSize ReadImageSize(const fs::path& path) {
  if (const auto size = ReadSizeFromHeader(path)) {
    CheckWhole(path);
    return *size;
  }
  const cv::Mat image = Decode(path, cv::IMREAD_ANYCOLOR | cv::IMREAD_ANYDEPTH);
  return {image.cols, image.rows};
}

ImageSize ShrunkSize(ImageSize size, int max_image_size) {
  const int longer = std::max(size.width, size.height);
  if (max_image_size < 0 || longer <= max_image_size) return size;
  const double factor = static_cast<double>(max_image_size) / longer;
  const auto shrink = [&](int side) {
    return std::max(1, static_cast<int>(std::lround(side * factor)));
  };
  return {shrink(size.width), shrink(size.height)};
}

void CheckDecodable(const fs::path& path, ImageSize stored, int max_image_size) {
  const int64_t reduction = ReductionOf(path, stored, max_image_size);
  const int64_t num_decoded = NumPixels(stored) / (reduction * reduction);
  if (num_decoded <= kMaxDecodedPixels && NumPixels(stored) <= kMaxStoredPixels) return;
  throw IoError(path.string(),
                "too large to decode: " + Text(stored) + " pixels, at most " +
                    std::to_string(kMaxDecodedPixels / 1'000'000) +
                    " megapixels are decoded (JPEG files: reduced for a lower --max_image_size, "
                    "at most " +
                    std::to_string(kMaxStoredPixels / 1'000'000) + " megapixels are stored)");
}

Image ReadImage(const fs::path& path, int max_image_size) {
  int reduction = 1;
  const auto size = ReadSizeFromHeader(path);
  if (size) {
    CheckDecodable(path, *size, max_image_size);
    reduction = ReductionOf(path, *size, max_image_size);
  }
  cv::Mat stored =
      Decode(path, cv::IMREAD_ANYCOLOR | cv::IMREAD_ANYDEPTH | ReductionFlag(reduction));
  double scale = 1;
  if (stored.depth() == CV_16U) {
    scale = 1.0 / 257;
  } else if (stored.depth() != CV_8U) {
    throw IoError(path.string(), "only images of 8 or 16 bits per channel can be used");
  }
  if (stored.channels() == 3) cv::cvtColor(stored, stored, cv::COLOR_BGR2RGB);
  cv::Mat levels;
  stored.convertTo(levels, CV_32F, scale);
  levels = reduction == 1 ? Shrink(levels, max_image_size)
                          : ShrinkReduced(levels, *size, reduction, max_image_size);

  Image image;
  image.width = levels.cols;
  image.height = levels.rows;
  image.channels = levels.channels();
  const float* first = levels.ptr<float>();
  image.data.assign(first, first + levels.total() * levels.channels());
  return image;
}

std::vector<unsigned char> ReadMask(const fs::path& path, ImageSize expected, int max_image_size) {
  const auto check_size = [&](ImageSize size) {
    if (size == expected) return;
    throw IoError(path.string(),
                  "the mask is " + Text(size) + " pixels, its image " + Text(expected));
  };
  if (const auto size = ReadSizeFromHeader(path)) {
    check_size(*size);
    CheckDecodable(path, *size, -1);
  }
  const cv::Mat stored = Decode(path, cv::IMREAD_GRAYSCALE);
  check_size({stored.cols, stored.rows});
  cv::Mat use;
  cv::Mat(stored != 0).convertTo(use, CV_32F);
  use = Shrink(use, max_image_size);
  std::vector<unsigned char> mask;
  mask.reserve(use.total());
  for (int y = 0; y < use.rows; ++y) {
    const float* row = use.ptr<float>(y);
    std::transform(row, row + use.cols, std::back_inserter(mask),
                   [](float value) { return static_cast<unsigned char>(value > 254.9f); });
  }
  return mask;
}

}  // namespace limn::colmap_ext
