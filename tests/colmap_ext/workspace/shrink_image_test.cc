// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/shrink_image.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace limn::colmap_ext {
namespace {

// Both filters are one: also of sides that the reduction does not divide, whose last pixels are
// only partly of the image.
TEST(ShrinkImage, RowsOneByOneBecomeTheSame) {
  for (const int reduction : {1, 2, 8}) {
    const ImageSize stored{8 * 61 + 1, 8 * 47 + 3};
    cv::Mat noise((stored.height + reduction - 1) / reduction,
                  (stored.width + reduction - 1) / reduction, CV_8UC3);
    cv::RNG(1).fill(noise, cv::RNG::UNIFORM, 0, 255);
    const Shrinking shrinking{stored, reduction, 0.5};
    cv::Mat expected(19, 25, CV_32FC3), shrunk(19, 25, CV_32FC3);
    Shrink(noise, shrinking, &expected);
    ShrinkRowByRow(noise, shrinking, &shrunk);
    // OpenCV leaves out shares of pixels below 0.001.
    EXPECT_LT(cv::norm(shrunk, expected, cv::NORM_INF), 0.3) << reduction;
  }
}

}  // namespace
}  // namespace limn::colmap_ext
