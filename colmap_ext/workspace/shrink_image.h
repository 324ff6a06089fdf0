// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "colmap_ext/workspace/image_size.h"

namespace limn::colmap_ext {

// How to shrink an image that was decoded at 1 / reduction of its size.
struct Shrinking {
  ImageSize stored;
  int reduction = 1;
  double scale = 1;  // of values
  double shift = 0;  // added to the scaled values
};

// By an area filter to the size of `result`, which is of floats. The last column and row of a
// reduced image may reach beyond the stored image; the factors are those of the stored image all
// the same. Images of at most 64 megapixels are copied in floating point, which takes 12 bytes per
// pixel; larger ones are shrunk by ShrinkRowByRow.
void Shrink(const cv::Mat& image, const Shrinking& shrinking, cv::Mat* result);

// The same to 0.3 gray levels without such a copy, but slower.
void ShrinkRowByRow(const cv::Mat& image, const Shrinking& shrinking, cv::Mat* result);

}  // namespace limn::colmap_ext
