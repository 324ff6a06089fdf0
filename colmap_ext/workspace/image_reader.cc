// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/image_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <new>
#include <string>
#include <system_error>
#include <type_traits>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "colmap_ext/workspace/image_header.h"
#include "colmap_ext/workspace/jpeg_check.h"
#include "colmap_ext/workspace/shrink_image.h"
#include "colmap_ext/workspace/tiff_directory.h"
#include "limn/files/quiet_decoders.h"
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

[[noreturn]] void FailTruncated(const fs::path& path) {
  throw IoError(path.string(), "truncated: the file ends before the picture does");
}

// Some programs leave out the end marker of a JPEG file.
void CheckWhole(const fs::path& path) {
  if (!IsTruncated(path)) return;
  if (FormatOf(path) != ImageFormat::kJpeg) FailTruncated(path);
  const auto complaint = CheckJpeg(path);
  if (complaint && complaint->is_truncated) FailTruncated(path);
}

void CheckDeveloped(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  const auto directory = LargestTiffDirectory(in);
  if (!directory || !directory->is_raw) return;
  throw IoError(path.string(),
                "is a raw file: its picture in full size is not developed. Convert it to TIFF, PNG "
                "or JPEG, as for structure from motion");
}

ImageSize StoredSize(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw IoError(path.string(), "no such image file");
  CheckIsFile(path.string());
  const auto size = ReadSizeFromHeader(path);
  if (size && FormatOf(path) == ImageFormat::kTiff) CheckDeveloped(path);
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

// Decoders take the first picture of a TIFF file, and turn some.
cv::Mat DecodeTiff(const fs::path& path, int flags) {
  std::ifstream in(path, std::ios::binary);
  const auto directory = LargestTiffDirectory(in);
  if (!directory || (directory->is_first && directory->orientation == 1)) {
    return cv::imread(path.string(), flags);
  }
  const std::string bytes = WithFirstDirectory(ReadWholeFile(path.string()), *directory);
  const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()));
  return cv::imdecode(buffer, flags);
}

// At 1 / reduction of its size.
cv::Mat Decode(const fs::path& path, ImageSize stored, int reduction, int flags) {
  const QuietDecoders quiet;
  flags |= ReductionFlag(reduction) | cv::IMREAD_IGNORE_ORIENTATION;
  cv::Mat image = FormatOf(path) == ImageFormat::kTiff ? DecodeTiff(path, flags)
                                                       : cv::imread(path.string(), flags);
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

void Flip(int orientation, const cv::Mat& from, cv::Mat* to) {
  constexpr int kUpsideDown = 0, kMirrored = 1, kBoth = -1;
  if (orientation == 2 || orientation == 6) cv::flip(from, *to, kMirrored);
  if (orientation == 3 || orientation == 7) cv::flip(from, *to, kBoth);
  if (orientation == 4 || orientation == 8) cv::flip(from, *to, kUpsideDown);
}

// Upright, from a picture of this EXIF orientation. `to` has the size of the result.
void Turn(int orientation, const cv::Mat& from, cv::Mat* to) {
  if (orientation < 5) {
    Flip(orientation, from, to);
    return;
  }
  cv::Mat transposed;
  cv::transpose(from, transposed);
  if (orientation == 5) {
    transposed.copyTo(*to);
  } else {
    Flip(orientation, transposed, to);
  }
}

// `decoded` has channels in the order of the result.
Image ShrunkImage(const cv::Mat& decoded, const Shrinking& shrinking, int max_image_size,
                  int orientation) {
  const ImageSize shrunk = ShrunkSize(shrinking.stored, max_image_size);
  const ImageSize size = Turned(shrunk, orientation);
  Image image;
  image.width = size.width;
  image.height = size.height;
  image.channels = decoded.channels();
  image.data.resize(static_cast<size_t>(size.NumPixels()) * image.channels);
  cv::Mat levels(size.height, size.width, CV_32FC(image.channels), image.data.data());
  if (orientation == 1) {
    Shrink(decoded, shrinking, &levels);
  } else {
    cv::Mat stored(shrunk.height, shrunk.width, levels.type());
    Shrink(decoded, shrinking, &stored);
    Turn(orientation, stored, &levels);
  }
  return image;
}

// Of 16 bits.
void SetRange(const LevelRange& range, Shrinking* shrinking) {
  shrinking->scale = 255 / (range.high - range.low);
  shrinking->shift = -range.low * shrinking->scale;
}

// A range leaves out a few levels at its ends.
void Clamp(Image* image) {
  for (float& level : image->data) level = std::clamp(level, 0.0F, 255.0F);
}

Image ReadLevels(const fs::path& path, int max_image_size, const ImageForm& form) {
  Shrinking shrinking;
  shrinking.stored = StoredSize(path);
  CheckDecodable(path, shrinking.stored, max_image_size);
  shrinking.reduction = ReductionOf(path, shrinking.stored, max_image_size);
  if (auto jpeg = DecodeJpeg(path, shrinking.reduction)) {
    const cv::Mat decoded(jpeg->height, jpeg->width, CV_8UC(jpeg->channels), jpeg->data.data());
    CheckDecoded(path, decoded, shrinking.stored, shrinking.reduction);
    return ShrunkImage(decoded, shrinking, max_image_size, form.orientation);
  }
  const cv::Mat decoded = Decode(path, shrinking.stored, shrinking.reduction,
                                 cv::IMREAD_ANYCOLOR | cv::IMREAD_ANYDEPTH);
  shrinking.scale = LevelScale(decoded);
  if (shrinking.scale == 0) {
    throw IoError(path.string(), "only images of 8 or 16 bits per channel can be used");
  }
  if (form.range && decoded.depth() == CV_16U) SetRange(*form.range, &shrinking);
  Image image = ShrunkImage(decoded, shrinking, max_image_size, form.orientation);
  if (form.range) Clamp(&image);
  if (image.channels == 3) SwapRedAndBlue(&image);
  return image;
}

// 255 where a channel is above the threshold.
cv::Mat AnyAbove(const cv::Mat& image, double threshold) {
  std::vector<cv::Mat> channels;
  cv::split(image, channels);
  cv::Mat any = channels[0] > threshold;
  for (size_t c = 1; c < channels.size(); ++c) any |= channels[c] > threshold;
  return any;
}

double LargestOf(const cv::Mat& channels) {
  double largest = 0;
  cv::minMaxLoc(channels.reshape(1), nullptr, &largest);
  return largest;
}

bool IsLossy(const fs::path& path) {
  const ImageFormat format = FormatOf(path);
  return format == ImageFormat::kJpeg || format == ImageFormat::kWebp ||
         format == ImageFormat::kJpeg2000;
}

// 255 where a mask is not zero.
cv::Mat UseOf(const fs::path& path, const cv::Mat& decoded) {
  if (LevelScale(decoded) == 0) {
    throw IoError(path.string(), "only masks of up to 16 bits per channel can be used");
  }
  cv::Mat colors = decoded, alpha;
  if (decoded.channels() == 4) {
    cv::extractChannel(decoded, alpha, 3);
    cv::cvtColor(decoded, colors, cv::COLOR_BGRA2BGR);
  }
  const double largest = LargestOf(colors);
  const cv::Mat use = AnyAbove(colors, IsLossy(path) ? largest / 2 : 0);
  if (alpha.empty() || cv::countNonZero(alpha) == 0) return use;
  const cv::Mat opaque = alpha != 0;
  return largest == 0 ? opaque : use & opaque;
}

// At the size `wanted`, nonzero where all of a pixel is to be used.
std::vector<unsigned char> ShrunkUse(const cv::Mat& use, ImageSize wanted) {
  cv::Mat shrunk(wanted.height, wanted.width, CV_32FC1);
  if (use.cols < wanted.width || use.rows < wanted.height) {
    cv::Mat enlarged;
    cv::resize(use, enlarged, {wanted.width, wanted.height}, 0, 0, cv::INTER_NEAREST);
    enlarged.convertTo(shrunk, CV_32F);
  } else {
    Shrink(use, {.stored = {use.cols, use.rows}}, &shrunk);
  }
  std::vector<unsigned char> mask;
  mask.reserve(shrunk.total());
  for (int y = 0; y < shrunk.rows; ++y) {
    const float* row = shrunk.ptr<float>(y);
    std::transform(row, row + shrunk.cols, std::back_inserter(mask),
                   [](float value) { return static_cast<unsigned char>(value > 254.9f); });
  }
  return mask;
}

// 255 where it is at least half opaque.
cv::Mat OpaquePart(const cv::Mat& decoded) {
  cv::Mat alpha;
  cv::extractChannel(decoded, alpha, 3);
  return alpha >= (decoded.depth() == CV_16U ? 32768 : 128);
}

// Of values of 16 bits without alpha, but for one in ten thousand at either end.
LevelRange RangeOf(const cv::Mat& image, const cv::Mat& opaque) {
  std::vector<uint64_t> histogram(1 << 16, 0);
  uint64_t count = 0;
  const int num_colors = image.channels() == 4 ? 3 : image.channels();
  for (int y = 0; y < image.rows; ++y) {
    const auto* row = image.ptr<uint16_t>(y);
    const unsigned char* use = opaque.empty() ? nullptr : opaque.ptr(y);
    for (int x = 0; x < image.cols; ++x) {
      if (use && !use[x]) continue;
      for (int c = 0; c < num_colors; ++c) ++histogram[row[x * image.channels() + c]];
      count += num_colors;
    }
  }
  const uint64_t outside = count / 10000;
  const auto value_above = [&](uint64_t num_below) {
    uint64_t sum = 0;
    size_t value = 0;
    while (value + 1 < histogram.size() && (sum += histogram[value]) <= num_below) ++value;
    return static_cast<double>(value);
  };
  if (count == 0) return {0, 0};
  return {value_above(outside), value_above(count - 1 - outside)};
}

cv::Mat TurnedUse(const cv::Mat& use, int orientation) {
  if (orientation == 1) return use;
  const ImageSize size = Turned(ImageSize{use.cols, use.rows}, orientation);
  cv::Mat turned(size.height, size.width, use.type());
  Turn(orientation, use, &turned);
  return turned;
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
  checked.size = StoredSize(path);
  CheckDecodable(path, checked.size, max_image_size);
  checked.complaint = WithNamedErrors(path, [&] { return CheckJpeg(path); });
  if (FormatOf(path) != ImageFormat::kJpeg) CheckWhole(path);
  if (checked.complaint && checked.complaint->is_truncated) FailTruncated(path);
  return checked;
}

Image ReadImage(const fs::path& path, int max_image_size, const ImageForm& form) {
  return WithNamedErrors(path, [&] { return ReadLevels(path, max_image_size, form); });
}

Image ImageFromPixels(const PhotoPixels& pixels, int max_image_size, const ImageForm& form) {
  return std::visit(
      [&](const auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        const cv::Mat decoded(pixels.size.height, pixels.size.width,
                              CV_MAKETYPE(cv::DataType<Value>::depth, pixels.channels),
                              const_cast<Value*>(values.data()));
        Shrinking shrinking = {.stored = pixels.size};
        shrinking.scale = std::is_floating_point_v<Value> ? 255 : LevelScale(decoded);
        if (form.range && decoded.depth() == CV_16U) SetRange(*form.range, &shrinking);
        Image image = ShrunkImage(decoded, shrinking, max_image_size, form.orientation);
        if (form.range) Clamp(&image);
        return image;
      },
      pixels.values);
}

std::vector<unsigned char> ReadMask(const fs::path& path, ImageSize expected, int max_image_size,
                                    int orientation) {
  const ImageSize stored = ReadImageSize(path);
  const bool is_upright = IsResized(stored, expected.width, expected.height);
  const ImageSize turned = Turned(stored, orientation);
  if (!is_upright && !IsResized(turned, expected.width, expected.height)) {
    throw IoError(path.string(), "the mask is " + Text(stored) + " pixels, its image " +
                                     Text(expected) +
                                     ": the aspect must be the same; masks of distorted images "
                                     "must be undistorted like them");
  }
  CheckDecodable(path, stored, max_image_size);
  return WithNamedErrors(path, [&] {
    const cv::Mat use = UseOf(path, Decode(path, stored, 1, cv::IMREAD_UNCHANGED));
    return ShrunkUse(TurnedUse(use, is_upright ? 1 : orientation),
                     ShrunkSize(expected, max_image_size));
  });
}

std::vector<unsigned char> ReadAlpha(const fs::path& path, int max_image_size,
                                     const ImageForm& form) {
  const ImageSize stored = StoredSize(path);
  CheckDecodable(path, stored, max_image_size);
  return WithNamedErrors(path, [&] {
    const cv::Mat decoded = Decode(path, stored, 1, cv::IMREAD_UNCHANGED);
    if (decoded.channels() != 4) throw IoError(path.string(), "has lost its alpha channel");
    const ImageSize size = Turned(stored, form.orientation);
    return ShrunkUse(TurnedUse(OpaquePart(decoded), form.orientation),
                     ShrunkSize(size, max_image_size));
  });
}

PixelScan ScanPixels(const fs::path& path) {
  const ImageSize stored = StoredSize(path);
  CheckDecodable(path, stored, 1);  // nothing is shrunk
  return WithNamedErrors(path, [&] {
    const cv::Mat decoded = Decode(path, stored, 1, cv::IMREAD_UNCHANGED);
    PixelScan scan;
    cv::Mat opaque;
    if (decoded.channels() == 4) {
      opaque = OpaquePart(decoded);
      const auto num_opaque = static_cast<size_t>(cv::countNonZero(opaque));
      scan.has_mask = num_opaque > 0 && num_opaque < opaque.total();
    }
    if (decoded.depth() == CV_16U)
      scan.values = RangeOf(decoded, scan.has_mask ? opaque : cv::Mat());
    return scan;
  });
}

PixelScan ScanPixels(const PhotoPixels& pixels) {
  const auto* values = std::get_if<std::vector<uint16_t>>(&pixels.values);
  if (!values) return {};
  const cv::Mat image(pixels.size.height, pixels.size.width, CV_16UC(pixels.channels),
                      const_cast<uint16_t*>(values->data()));
  return {RangeOf(image, {}), false};
}

std::optional<LevelRange> RangeToShow(const LevelRange& values) {
  constexpr double kLeast = 32;
  constexpr double kHalf = 32768;
  const double width = values.high - values.low;
  if (width < kLeast || width >= kHalf) return std::nullopt;
  double step = 1;
  while (8 * step < width) step *= 2;
  const LevelRange range = {std::floor(values.low / step) * step,
                            std::ceil(values.high / step) * step};
  return range.high - range.low <= kHalf ? std::optional(range) : std::nullopt;
}

}  // namespace limn::colmap_ext
