// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/shrink_image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <opencv2/imgproc.hpp>

namespace limn::colmap_ext {
namespace {

// So that an image (6 bytes per pixel), its copy (12) and the result (12) fit in 2 GB.
constexpr int64_t kMaxCopiedPixels = 64'000'000;

// Pixels of the result per pixel of the image.
struct ShrinkFactors {
  double x = 1;
  double y = 1;
};

ShrinkFactors FactorsOf(const Shrinking& shrinking, const cv::Mat& result) {
  const ImageSize stored = shrinking.stored;
  return {static_cast<double>(result.cols) * shrinking.reduction / stored.width,
          static_cast<double>(result.rows) * shrinking.reduction / stored.height};
}

}  // namespace

void Shrink(const cv::Mat& image, const Shrinking& shrinking, cv::Mat* result) {
  if (result->size() == image.size()) {
    image.convertTo(*result, CV_32F, shrinking.scale, shrinking.shift);
  } else if (ImageSize{image.cols, image.rows}.NumPixels() > kMaxCopiedPixels) {
    ShrinkRowByRow(image, shrinking, result);
  } else {
    const ShrinkFactors factors = FactorsOf(shrinking, *result);
    cv::Mat levels;
    image.convertTo(levels, CV_32F, shrinking.scale, shrinking.shift);
    cv::resize(levels, *result, {}, factors.x, factors.y, cv::INTER_AREA);
  }
}

void ShrinkRowByRow(const cv::Mat& image, const Shrinking& shrinking, cv::Mat* result) {
  const ShrinkFactors factors = FactorsOf(shrinking, *result);
  *result = 0;
  for (int y = 0; y < result->rows; ++y) {
    const double begin = y / factors.y;
    const double end = std::min<double>((y + 1) / factors.y, image.rows);
    const cv::Range range(static_cast<int>(begin), static_cast<int>(std::ceil(end)));
    cv::Mat levels, narrow;
    image.rowRange(range).convertTo(levels, CV_32F, shrinking.scale * factors.y,
                                    shrinking.shift * factors.y);
    cv::resize(levels, narrow, {}, factors.x, 1, cv::INTER_AREA);
    for (int i = range.start; i < range.end; ++i) {
      const double share = std::min(end, i + 1.0) - std::max<double>(begin, i);
      cv::scaleAdd(narrow.row(i - range.start), share, result->row(y), result->row(y));
    }
  }
}

}  // namespace limn::colmap_ext
