#include "colmap_ext/workspace/image_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <new>
#include <string>
#include <system_error>
#include <type_traits>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "colmap_ext/workspace/image_header.h"
#include "colmap_ext/workspace/jpeg_check.h"
#include "colmap_ext/workspace/quiet_decoders.h"
#include "colmap_ext/workspace/shrink_image.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// Larger JPEG images are decoded reduced where possible.
constexpr int64_t kLargePixels = 16'000'000;
// Of one image.
constexpr double kMaxDecoderBytes = 2e9;
constexpr double kBytesPerDecodedPixel = 6;
constexpr double kBytesPerPixel = 12;

int LongerSide(ImageSize size) { return std::max(size.width, size.height); }

void CheckWhole(const fs::path& path) {
  if (!IsTruncated(path)) return;
  throw IoError(path.string(), "truncated: the file ends before the picture does");
}

ImageSize StoredSize(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw IoError(path.string(), "no such image file");
  CheckIsFile(path.string());
  const auto size = ReadSizeFromHeader(path);
  if (size) return *size;
  throw IoError(path.string(),
                "cannot be decoded as an image: no header of a PNG, JPEG, TIFF, BMP, WebP, JPEG "
                "2000, PNM or Sun raster file");
}

// Of the image and the memory of its decoder.
double DecoderBytesPerPixel(const fs::path& path) {
  switch (FormatOf(path)) {
    case ImageFormat::kJpeg2000:
      return 30;  // 32 bits per channel, twice
    case ImageFormat::kTiff:
      return 18;  // one strip with all rows, as stored and decoded
    case ImageFormat::kWebp:
      return 8;
    default:
      return kBytesPerDecodedPixel;  // 16 bits per channel, or a progressive JPEG file
  }
}

// Of JPEG files, whose decoder reduces by powers of two: 1, 2, 4 or 8, so that a large image is
// still at least twice as large as wanted, and an area filter has the last word.
int ReductionOf(const fs::path& path, ImageSize stored, int max_image_size) {
  const int wanted = LongerSide(ShrunkSize(stored, max_image_size));
  if (stored.NumPixels() <= kLargePixels || FormatOf(path) != ImageFormat::kJpeg) return 1;
  int reduction = 1;
  while (reduction < 8 && LongerSide(stored) >= 4 * reduction * wanted) reduction *= 2;
  return reduction;
}

// OpenCV's flags: IMREAD_REDUCED_GRAYSCALE_2 = 16 and so on also reduce color, with others.
int ReductionFlag(int reduction) { return reduction == 1 ? 0 : 8 * reduction; }

// What `read` returns; errors of OpenCV and too little memory become IoErrors.
template <typename Read>
auto WithNamedErrors(const fs::path& path, const Read& read) {
  constexpr const char* kNoMemory =
      "does not fit in memory: lower --max_image_size or --num_threads";
  try {
    return read();
  } catch (const std::bad_alloc&) {
    throw IoError(path.string(), kNoMemory);
  } catch (const cv::Exception& error) {
    if (error.code == cv::Error::StsNoMem) throw IoError(path.string(), kNoMemory);
    throw IoError(path.string(), "cannot be decoded: " + error.err);
  }
}

void CheckDecoded(const fs::path& path, const cv::Mat& image, ImageSize stored, int reduction) {
  if (image.empty()) throw IoError(path.string(), "cannot be decoded as an image");
  const auto reduced = [&](int side) { return (side + reduction - 1) / reduction; };
  if (image.cols == reduced(stored.width) && image.rows == reduced(stored.height)) return;
  throw IoError(path.string(), "has " + Text({image.cols, image.rows}) +
                                   " pixels when decoded, but its header says " + Text(stored));
}

// At 1 / reduction of its size.
cv::Mat Decode(const fs::path& path, ImageSize stored, int reduction, int flags) {
  const QuietDecoders quiet;
  cv::Mat image =
      cv::imread(path.string(), flags | ReductionFlag(reduction) | cv::IMREAD_IGNORE_ORIENTATION);
  CheckDecoded(path, image, stored, reduction);
  return image;
}

// Of values that scale to gray levels; 0 for kinds of values that photographs do not have.
double LevelScale(const cv::Mat& image) {
  if (image.depth() == CV_8U) return 1;
  return image.depth() == CV_16U ? 1.0 / 257 : 0;
}

// To and from OpenCV's order of colors.
void SwapRedAndBlue(Image* image) {
  for (size_t i = 0; i + 2 < image->data.size(); i += 3) {
    std::swap(image->data[i], image->data[i + 2]);
  }
}

// `decoded` has channels in the order of the result.
Image ShrunkImage(const cv::Mat& decoded, const Shrinking& shrinking, int max_image_size) {
  const ImageSize size = ShrunkSize(shrinking.stored, max_image_size);
  Image image;
  image.width = size.width;
  image.height = size.height;
  image.channels = decoded.channels();
  image.data.resize(static_cast<size_t>(size.NumPixels()) * image.channels);
  cv::Mat levels(size.height, size.width, CV_32FC(image.channels), image.data.data());
  Shrink(decoded, shrinking, &levels);
  return image;
}

Image ReadLevels(const fs::path& path, int max_image_size) {
  Shrinking shrinking;
  shrinking.stored = StoredSize(path);
  CheckDecodable(path, shrinking.stored, max_image_size);
  shrinking.reduction = ReductionOf(path, shrinking.stored, max_image_size);
  if (auto jpeg = DecodeJpeg(path, shrinking.reduction)) {
    const cv::Mat decoded(jpeg->height, jpeg->width, CV_8UC(jpeg->channels), jpeg->data.data());
    CheckDecoded(path, decoded, shrinking.stored, shrinking.reduction);
    return ShrunkImage(decoded, shrinking, max_image_size);
  }
  const cv::Mat decoded = Decode(path, shrinking.stored, shrinking.reduction,
                                 cv::IMREAD_ANYCOLOR | cv::IMREAD_ANYDEPTH);
  shrinking.scale = LevelScale(decoded);
  if (shrinking.scale == 0) {
    throw IoError(path.string(), "only images of 8 or 16 bits per channel can be used");
  }
  Image image = ShrunkImage(decoded, shrinking, max_image_size);
  if (image.channels == 3) SwapRedAndBlue(&image);
  return image;
}

// Nonzero where the file is nonzero in the whole area of a pixel.
std::vector<unsigned char> ReadUse(const fs::path& path, ImageSize stored, int max_image_size) {
  const cv::Mat decoded = Decode(path, stored, 1, cv::IMREAD_GRAYSCALE);
  const ImageSize size = ShrunkSize(stored, max_image_size);
  cv::Mat use(size.height, size.width, CV_32FC1);
  Shrink(decoded != 0, {.stored = stored}, &use);
  std::vector<unsigned char> mask;
  mask.reserve(use.total());
  for (int y = 0; y < use.rows; ++y) {
    const float* row = use.ptr<float>(y);
    std::transform(row, row + use.cols, std::back_inserter(mask),
                   [](float value) { return static_cast<unsigned char>(value > 254.9f); });
  }
  return mask;
}

}  // namespace

ImageSize ReadImageSize(const fs::path& path) {
  const ImageSize size = StoredSize(path);
  CheckWhole(path);
  return size;
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
  const auto num_stored = static_cast<double>(stored.NumPixels());
  const auto num_pixels = static_cast<double>(ShrunkSize(stored, max_image_size).NumPixels());
  const double of_decoder = DecoderBytesPerPixel(path) * num_stored;
  const double bytes =
      std::max(of_decoder, kBytesPerDecodedPixel * num_stored + kBytesPerPixel * num_pixels);
  if (bytes <= kMaxDecoderBytes) return;
  const auto megabytes = [](double value) {
    return std::to_string(static_cast<int64_t>(value / 1e6));
  };
  throw IoError(
      path.string(),
      "too large to decode: " + Text(stored) + " pixels may take " + megabytes(bytes) +
          " MB, at most " + megabytes(kMaxDecoderBytes) + ": " +
          (of_decoder < kMaxDecoderBytes ? "lower --max_image_size" : "make the file smaller"));
}

CheckedImage CheckImage(const fs::path& path, int max_image_size) {
  CheckedImage checked;
  checked.size = ReadImageSize(path);
  CheckDecodable(path, checked.size, max_image_size);
  checked.complaint = WithNamedErrors(path, [&] { return CheckJpeg(path); });
  return checked;
}

Image ReadImage(const fs::path& path, int max_image_size) {
  return WithNamedErrors(path, [&] { return ReadLevels(path, max_image_size); });
}

Image ImageFromPixels(const PhotoPixels& pixels, int max_image_size) {
  return std::visit(
      [&](const auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        const cv::Mat decoded(pixels.size.height, pixels.size.width,
                              CV_MAKETYPE(cv::DataType<Value>::depth, pixels.channels),
                              const_cast<Value*>(values.data()));
        const double scale = std::is_floating_point_v<Value> ? 255 : LevelScale(decoded);
        return ShrunkImage(decoded, {.stored = pixels.size, .scale = scale}, max_image_size);
      },
      pixels.values);
}

std::vector<unsigned char> ReadMask(const fs::path& path, ImageSize expected, int max_image_size) {
  const ImageSize stored = ReadImageSize(path);
  if (stored != expected) {
    throw IoError(path.string(),
                  "the mask is " + Text(stored) + " pixels, its image " + Text(expected));
  }
  CheckDecodable(path, stored, max_image_size);
  return WithNamedErrors(path, [&] { return ReadUse(path, stored, max_image_size); });
}

}  // namespace limn::colmap_ext
