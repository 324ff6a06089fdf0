// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pictures/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <string_view>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <zlib.h>

#include "limn/files/atomic_file.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// OpenCV draws at fractions of a pixel given as integers with this many binary digits.
constexpr int kShift = 6;

cv::Mat MatOf(Picture* picture) {
  return cv::Mat(picture->height, picture->width, CV_8UC3, picture->rgb.data());
}

cv::Point FixedPoint(const Eigen::Vector2d& point) {
  // OpenCV counts in int: far away is far enough.
  constexpr double kFar = 1e6;
  const Eigen::Vector2d bounded = point.cwiseMax(-kFar).cwiseMin(kFar);
  const double unit = 1 << kShift;
  return {static_cast<int>(std::lround(bounded.x() * unit)),
          static_cast<int>(std::lround(bounded.y() * unit))};
}

cv::Scalar ScalarOf(const Color& color) {
  return {1. * color.red, 1. * color.green, 1. * color.blue};
}

// Signature and first chunk.
constexpr size_t kPngHeaderBytes = 33;

std::string BigEndian(uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFF);
  return bytes;
}

std::string SoftwareChunk() {
  constexpr size_t kKindBytes = 4;
  const auto checksum = static_cast<uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(kPngOfLimn.data()), kPngOfLimn.size()));
  return BigEndian(static_cast<uint32_t>(kPngOfLimn.size() - kKindBytes))
      .append(kPngOfLimn)
      .append(BigEndian(checksum));
}

uint8_t ToByte(double value) { return static_cast<uint8_t>(std::clamp(value, 0.0, 255.0) + 0.5); }

}  // namespace

Canvas::Canvas(int width, int height, int scale)
    : scale_(scale, scale), picture_{width * scale, height * scale, {}} {
  picture_.rgb.assign(3 * static_cast<size_t>(picture_.width) * picture_.height, 255);
}

Canvas::Canvas(const Image& photo, double brightness, int scale)
    : Canvas(photo.width, photo.height, scale) {
  scale_ /= photo.scale.array();
  uint8_t* to = picture_.rgb.data();
  const int second = photo.channels == 3 ? 1 : 0;
  for (int y = 0; y < picture_.height; ++y) {
    const float* from =
        photo.data.data() + static_cast<size_t>(y / scale) * photo.width * photo.channels;
    for (int x = 0; x < photo.width; ++x, from += photo.channels) {
      const std::array<uint8_t, 3> color = {ToByte(brightness * from[0]),
                                            ToByte(brightness * from[second]),
                                            ToByte(brightness * from[2 * second])};
      for (int copy = 0; copy < scale; ++copy) to = std::copy(color.begin(), color.end(), to);
    }
  }
}

Eigen::Vector2d Canvas::OnPicture(const Eigen::Vector2d& pixel) const {
  return scale_ * (pixel.array() + 0.5) - 0.5;
}

void Canvas::DrawLine(const std::vector<Eigen::Vector2d>& points, const Color& color, int width) {
  cv::Mat image = MatOf(&picture_);
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    cv::line(image, FixedPoint(OnPicture(points[i])), FixedPoint(OnPicture(points[i + 1])),
             ScalarOf(color), width, cv::LINE_AA, kShift);
  }
}

void Canvas::DrawDisc(const Eigen::Vector2d& center, double radius, const Color& color) {
  cv::Mat image = MatOf(&picture_);
  cv::circle(image, FixedPoint(OnPicture(center)),
             static_cast<int>(std::lround(radius * (1 << kShift))), ScalarOf(color), cv::FILLED,
             cv::LINE_AA, kShift);
}

void Canvas::DrawSquare(const Eigen::Vector2d& center, double radius, const Color& color) {
  DrawPolygon(center, {{-radius, -radius}, {radius, -radius}, {radius, radius}, {-radius, radius}},
              color);
}

void Canvas::DrawDiamond(const Eigen::Vector2d& center, double radius, const Color& color) {
  DrawPolygon(center, {{-radius, 0}, {0, -radius}, {radius, 0}, {0, radius}}, color);
}

void Canvas::DrawPolygon(const Eigen::Vector2d& center, const std::vector<Eigen::Vector2d>& corners,
                         const Color& color) {
  std::vector<cv::Point> polygon;
  for (const Eigen::Vector2d& corner : corners) {
    polygon.push_back(FixedPoint(OnPicture(center) + corner));
  }
  cv::Mat image = MatOf(&picture_);
  cv::fillConvexPoly(image, polygon, ScalarOf(color), cv::LINE_AA, kShift);
}

void WritePng(const OutputPath& path, const Picture& picture) {
  Picture copy = picture;
  cv::Mat bgr;
  cv::cvtColor(MatOf(&copy), bgr, cv::COLOR_RGB2BGR);
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".png", bgr, bytes)) throw IoError(path.string(), "cannot encode the picture");
  const std::string_view png(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  WriteFileAtomically(path, [&](std::ostream& out) {
    out << png.substr(0, kPngHeaderBytes) << SoftwareChunk() << png.substr(kPngHeaderBytes);
  });
}

OutputPath PicturePath(const OutputPath& folder, const std::string& image_name) {
  return folder / (image_name + ".png");
}

}  // namespace limn
