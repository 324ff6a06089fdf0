// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "limn/visibility/depth_image.h"

namespace limn {

// Counts the depth pixels that triangles or discs fill, and throws InputError if they are more than
// those of any surface in a picture: a hundred layers of it, or 10^8, and 50 for each of them.
class RasterWork {
 public:
  RasterWork(const DepthImage& image, size_t num_items);
  void Add(size_t num_pixels);

 private:
  size_t left_;
};

// Both functions change only depth pixels that are unknown or farther, and return how many pixels
// they looked at.

// Sets the depth pixels with centers in a convex polygon, border included, to `depth_at` of their
// position in the virtual image. Corners are in depth pixels (DepthImage::FromVirtual).
size_t FillPolygon(const std::vector<Eigen::Vector2d>& corners,
                   const std::function<double(const Eigen::Vector2d& virtual_px)>& depth_at,
                   DepthImage* image);

// Sets the depth pixels with centers within `radius` of a position, both in depth pixels, to z.
size_t FillDisc(const Eigen::Vector2d& center, double radius, float z, DepthImage* image);

}  // namespace limn
