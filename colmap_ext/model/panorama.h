// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Geometry>

#include "limn/geometry/pinhole_camera.h"
#include "limn/model/lens_map.h"

namespace limn::colmap_ext {

// A rectangle of a panorama. Columns continue across its left and right border, which are the same
// place.
struct ImageWindow {
  int x = 0;  // may be negative
  int y = 0;
  int width = 0;
  int height = 0;
  int image_width = 0;  // of the whole image
  int image_height = 0;

  bool IsOf(int width_px, int height_px) const {
    return image_width == width_px && image_height == height_px;
  }
  // Where a pixel of the image is in the window, or beside it on the nearer side.
  Eigen::Vector2d WindowFromImage(const Eigen::Vector2d& image_px) const;
};

// The rows of the window, as pixels of `channels` interleaved channels.
template <typename T>
std::vector<T> CutPixels(const std::vector<T>& pixels, const ImageWindow& window, int channels);

// A part of an EQUIRECTANGULAR image as a camera of its own: the window is its stored image, and
// the lens maps that to a pinhole image that looks at the middle of the part.
struct PanoramaPart {
  ImageWindow window;
  PinholeCamera camera;  // of the size of the window
  Eigen::Quaterniond part_from_image = Eigen::Quaterniond::Identity();
  std::shared_ptr<const LensMap> lens;
};

constexpr int kNumPanoramaParts = 12;

// Four parts around the horizon, up to 30 degrees from it, and four above and below each, up to 80
// degrees: the places above and below the camera, where the image is stretched six times and more,
// are in no part. Parts overlap only by a margin of `margin_px` pixels around each, which filters
// may reach into. A pixel of the pinhole image is as large as one of the panorama at the horizon.
std::vector<PanoramaPart> PanoramaParts(int width, int height, int margin_px);

template <typename T>
std::vector<T> CutPixels(const std::vector<T>& pixels, const ImageWindow& window, int channels) {
  std::vector<T> cut;
  cut.reserve(static_cast<size_t>(window.width) * window.height * channels);
  for (int y = window.y; y < window.y + window.height; ++y) {
    const auto row =
        pixels.begin() + static_cast<std::ptrdiff_t>(y) * window.image_width * channels;
    for (int x = window.x; x < window.x + window.width; ++x) {
      const int column = (x % window.image_width + window.image_width) % window.image_width;
      const auto pixel = row + static_cast<std::ptrdiff_t>(column) * channels;
      cut.insert(cut.end(), pixel, pixel + channels);
    }
  }
  return cut;
}

}  // namespace limn::colmap_ext
