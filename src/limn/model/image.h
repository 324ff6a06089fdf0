#pragma once

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
};

// RGB at a place, bilinear between the centers of pixels, which are at whole numbers; beyond the
// border the color of the border; gray as three equal values. Precondition: the image is not empty.
// Ignores masks.
Eigen::Vector3f ColorAt(const Image& image, const Eigen::Vector2d& px);

}  // namespace limn
