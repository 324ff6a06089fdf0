#include "colmap_ext/workspace/image_reader.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <system_error>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "colmap_ext/workspace/image_header.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

void CheckWhole(const fs::path& path) {
  if (!IsTruncated(path)) return;
  throw IoError(path.string(), "truncated: the file ends before the picture does");
}

cv::Mat Decode(const fs::path& path, int flags) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) throw IoError(path.string(), "no such image file");
  CheckWhole(path);
  cv::Mat image;
  try {
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

Image ReadImage(const fs::path& path, int max_image_size) {
  cv::Mat stored = Decode(path, cv::IMREAD_ANYCOLOR | cv::IMREAD_ANYDEPTH);
  double scale = 1;
  if (stored.depth() == CV_16U) {
    scale = 1.0 / 257;
  } else if (stored.depth() != CV_8U) {
    throw IoError(path.string(), "only images of 8 or 16 bits per channel can be used");
  }
  if (stored.channels() == 3) cv::cvtColor(stored, stored, cv::COLOR_BGR2RGB);
  cv::Mat levels;
  stored.convertTo(levels, CV_32F, scale);
  levels = Shrink(levels, max_image_size);

  Image image;
  image.width = levels.cols;
  image.height = levels.rows;
  image.channels = levels.channels();
  const float* first = levels.ptr<float>();
  image.data.assign(first, first + levels.total() * levels.channels());
  return image;
}

std::vector<unsigned char> ReadMask(const fs::path& path, ImageSize expected, int max_image_size) {
  const cv::Mat stored = Decode(path, cv::IMREAD_GRAYSCALE);
  const ImageSize size = {stored.cols, stored.rows};
  if (size != expected) {
    throw IoError(path.string(),
                  "the mask is " + Text(size) + " pixels, its image " + Text(expected));
  }
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
