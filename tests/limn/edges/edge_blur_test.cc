// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/edge_blur.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/synthetic_image.h"

namespace limn {
namespace {

// Discs with Gaussian borders of this standard deviation, sampled by the areas of pixels.
Image BlurredDiscs(double blur_px, double noise) {
  constexpr int kSize = 160;
  constexpr int kSubpixels = 4;
  Image image = testing::ConstantImage(kSize, kSize, {0});
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      double sum = 0;
      for (int i = 0; i < kSubpixels * kSubpixels; ++i) {
        const double u = x + (i % kSubpixels + 0.5) / kSubpixels - 0.5;
        const double v = y + (i / kSubpixels + 0.5) / kSubpixels - 0.5;
        const double distance =
            std::hypot(std::fmod(u + 0.5, 80) - 40, std::fmod(v + 0.5, 80) - 40);
        sum += 0.5 * std::erfc((distance - 25) / (std::sqrt(2.0) * blur_px));
      }
      image.data[y * kSize + x] = static_cast<float>(50 + 120 * sum / (kSubpixels * kSubpixels));
    }
  }
  testing::AddNoise(noise, 1, &image);
  testing::Quantize(&image);
  return image;
}

TEST(EdgeBlur, IsThatOfTheEdgesAndOfThePixels) {
  for (const double noise : {0.5, 2.0}) {
    for (const double blur_px : {0.3, 0.6, 1.0, 1.5}) {
      const auto measured = MeasureEdgeBlur(BlurredDiscs(blur_px, noise));
      ASSERT_TRUE(measured);
      EXPECT_NEAR(*measured, std::sqrt(blur_px * blur_px + 1.0 / 12), 0.08) << blur_px;
    }
  }
}

TEST(EdgeBlur, NothingWithoutStrongEdges) {
  Image noise = testing::ConstantImage(200, 200, {100});
  testing::AddNoise(5, 2, &noise);
  EXPECT_FALSE(MeasureEdgeBlur(noise));
  EXPECT_FALSE(MeasureEdgeBlur(testing::ConstantImage(3, 3, {7})));
}

TEST(EdgeBlur, MaskedEdgesDoNotCount) {
  Image image = BlurredDiscs(0.6, 1);
  image.mask.assign(image.data.size(), 0);
  EXPECT_FALSE(MeasureEdgeBlur(image));
}

}  // namespace
}  // namespace limn
