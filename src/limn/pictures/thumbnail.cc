// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pictures/thumbnail.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr int kJpegQuality = 75;
constexpr int kSmallestSide = 16;

// BGR, as OpenCV encodes it.
cv::Mat BytesOf(const Image& photo) {
  // OpenCV takes no const pixels; they are only read.
  const cv::Mat pixels(photo.height, photo.width, CV_MAKETYPE(CV_32F, photo.channels),
                       const_cast<float*>(photo.data.data()));
  cv::Mat bytes, bgr;
  pixels.convertTo(bytes, CV_8U);
  cv::cvtColor(bytes, bgr, photo.channels == 3 ? cv::COLOR_RGB2BGR : cv::COLOR_GRAY2BGR);
  return bgr;
}

void SetRectangle(const View& view, Thumbnail* thumbnail) {
  const Eigen::Vector2d size(view.camera.width, view.camera.height);
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(0.5);
  thumbnail->min_px = -half;
  thumbnail->max_px = size - half;
  if (!view.lens) return;
  const Eigen::Vector2d middle = 0.5 * size - half;
  thumbnail->min_px = (view.region.min_px - half).cwiseMax(middle - 2 * size);
  thumbnail->max_px = (view.region.max_px + half).cwiseMin(middle + 2 * size);
}

cv::Mat Shrunk(const cv::Mat& image, int width, int height) {
  cv::Mat small;
  cv::resize(image, small, {width, height}, 0, 0, cv::INTER_AREA);
  return small;
}

// The stored image is shrunk first, so that all its pixels count.
cv::Mat Undistorted(const cv::Mat& stored, const View& view, const Thumbnail& thumbnail, int width,
                    int height) {
  const Eigen::Vector2d extent = thumbnail.max_px - thumbnail.min_px;
  const Eigen::Vector2d step = extent.cwiseQuotient(Eigen::Vector2d(width, height));
  // Pixels of the view per pixel of the photograph.
  const double enlarged = view.camera.width / static_cast<double>(stored.cols);
  const double shrink = std::max(1.0, step.maxCoeff() / enlarged);
  const cv::Mat small =
      Shrunk(stored, std::max(1, static_cast<int>(std::lround(stored.cols / shrink))),
             std::max(1, static_cast<int>(std::lround(stored.rows / shrink))));
  const Eigen::Vector2d scale(static_cast<double>(small.cols) / view.camera.width,
                              static_cast<double>(small.rows) / view.camera.height);
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(0.5);
  cv::Mat map(height, width, CV_32FC2);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const Eigen::Vector2d place(column + 0.5, row + 0.5);
      const auto pixel = view.StoredFromVirtual(thumbnail.min_px + step.cwiseProduct(place));
      Eigen::Vector2d from = Eigen::Vector2d::Constant(-10);
      if (pixel) from = scale.cwiseProduct(*pixel + half) - half;
      map.at<cv::Vec2f>(row, column) = {static_cast<float>(from.x()), static_cast<float>(from.y())};
    }
  }
  cv::Mat virtual_image;
  cv::remap(small, virtual_image, map, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT);
  return virtual_image;
}

std::string JpegOf(const cv::Mat& picture) {
  std::vector<uchar> jpeg;
  if (!cv::imencode(".jpg", picture, jpeg, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality})) {
    throw std::runtime_error("a small picture of a photograph cannot be encoded");
  }
  return {jpeg.begin(), jpeg.end()};
}

int ScaledSide(int side, double factor) {
  return std::max(1, static_cast<int>(std::lround(factor * side)));
}

// Bytes go about with the number of pixels.
void SetJpeg(cv::Mat picture, size_t max_bytes, Thumbnail* thumbnail) {
  while (true) {
    thumbnail->jpeg = JpegOf(picture);
    thumbnail->longer_side = std::max(picture.cols, picture.rows);
    const double share = static_cast<double>(max_bytes) / thumbnail->jpeg.size();
    if (share >= 1 || thumbnail->longer_side <= kSmallestSide) return;
    const double factor = std::max(0.95 * std::sqrt(share),
                                   kSmallestSide / static_cast<double>(thumbnail->longer_side));
    picture = Shrunk(picture, ScaledSide(picture.cols, factor), ScaledSide(picture.rows, factor));
  }
}

}  // namespace

Thumbnail MakeThumbnail(const Image& photo, const View& view, const ThumbnailOptions& options) {
  CheckOption(options.longer_side >= kSmallestSide, "longer_side", options.longer_side, ">= 16");
  if (photo.ViewWidth() != view.camera.width || photo.ViewHeight() != view.camera.height) {
    throw InputError(view.name + ": the photograph has not the size of its camera");
  }
  Thumbnail thumbnail;
  SetRectangle(view, &thumbnail);
  const Eigen::Vector2d extent = thumbnail.max_px - thumbnail.min_px;
  if (!(extent.minCoeff() > 0)) return thumbnail;
  const double shrink = std::max(1.0, extent.maxCoeff() / options.longer_side);
  const int width = std::max(1, static_cast<int>(std::lround(extent.x() / shrink)));
  const int height = std::max(1, static_cast<int>(std::lround(extent.y() / shrink)));
  const cv::Mat bytes = BytesOf(photo);
  const cv::Mat picture =
      view.lens ? Undistorted(bytes, view, thumbnail, width, height) : Shrunk(bytes, width, height);
  SetJpeg(picture, options.max_bytes, &thumbnail);
  return thumbnail;
}

std::string SmallJpeg(const Image& photo, int longer_side) {
  const double factor =
      std::min(1.0, longer_side / static_cast<double>(std::max(photo.width, photo.height)));
  return JpegOf(
      Shrunk(BytesOf(photo), ScaledSide(photo.width, factor), ScaledSide(photo.height, factor)));
}

}  // namespace limn
