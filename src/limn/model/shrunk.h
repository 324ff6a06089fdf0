// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/model/image.h"
#include "limn/model/view.h"

namespace limn {

// A view with pixels `factor` times as large. Its optics do not change: it has no calibration.
View Shrunk(const View& view, double factor);

// The mean of blocks of factor x factor pixels; rows and columns that do not fill one are dropped.
// A block with a masked pixel is masked. The view of the image has the pixels of the result if it
// is shrunk by factor * View::scale, but for the rounding of its size. Precondition: the image has
// a block.
Image Shrunk(const Image& image, int factor);

// Pixels of a shrunk image in the image itself, and back.
inline Eigen::Vector2d GrownPx(const Eigen::Vector2d& px, double factor) {
  return (factor * px.array() + 0.5 * (factor - 1)).matrix();
}
inline Eigen::Vector2d ShrunkPx(const Eigen::Vector2d& px, double factor) {
  return ((px.array() - 0.5 * (factor - 1)) / factor).matrix();
}

}  // namespace limn
