// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Core>

namespace limn {

// A decoded photograph: interleaved rows of RGB or one gray channel, values in gray levels 0..255
// for any bit depth of the file. `mask` is empty or has one byte per pixel, 0 = do not use.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;  // 1 or 3
  std::vector<float> data;
  std::vector<unsigned char> mask;
  // Pixels of the view per pixel of the photograph.
  Eigen::Vector2d scale = Eigen::Vector2d::Ones();

  // A place in the view's pixels, lens distortion included, in those of the photograph, and back.
  Eigen::Vector2d FromView(const Eigen::Vector2d& view_px) const {
    return ((view_px.array() + 0.5) / scale.array() - 0.5).matrix();
  }
  Eigen::Vector2d ToView(const Eigen::Vector2d& image_px) const {
    return ((image_px.array() + 0.5) * scale.array() - 0.5).matrix();
  }
  // Whole pixels of the view.
  int ViewWidth() const { return static_cast<int>(width * scale.x() + 1e-6); }
  int ViewHeight() const { return static_cast<int>(height * scale.y() + 1e-6); }
};

// RGB at a place in the photograph's pixels, bilinear between the centers of pixels, which are at
// whole numbers; beyond the border the color of the border; gray as three equal values.
// Precondition: the image is not empty. Ignores masks.
Eigen::Vector3f ColorAt(const Image& image, const Eigen::Vector2d& px);

// A photograph with a pixel per pixel of its view, and no mask, bilinear.
Image AtViewSize(const Image& image);

}  // namespace limn
