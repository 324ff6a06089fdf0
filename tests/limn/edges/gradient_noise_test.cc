// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/gradient_noise.h"

#include <gtest/gtest.h>

#include "support/synthetic_image.h"

namespace limn {
namespace {

constexpr double kNoiseSigma = 1.5;

NoiseModel Measure(const Image& image) {
  const PaddedPlane plane =
      MakePaddedPlane(image.data, image.width, image.height, GaussianPadding(kNoiseSigma, 1));
  return MeasureNoise(
      plane, SmoothedGradient(plane, GaussianKernels(kNoiseSigma, 1), plane.width, plane.height),
      kNoiseSigma);
}

TEST(MeasureNoise, WhiteNoise) {
  for (const double noise : {1.0, 3.0, 8.0}) {
    Image image = testing::ConstantImage(320, 256, {128});
    testing::AddNoise(noise, 5, &image);
    const double truth = GradientNoiseFromPixelNoise(noise, kNoiseSigma, 1);
    const NoiseModel model = Measure(image);
    EXPECT_NEAR(model.Mean() / truth, 1, 0.1) << noise;
    EXPECT_NEAR(model.At(128) / truth, 1, 0.1) << noise;
  }
}

TEST(MeasureNoise, DependsOnGrayLevel) {
  Image image = testing::ConstantImage(512, 256, {40});
  testing::AddNoise(2, 5, &image);
  Image bright = testing::ConstantImage(512, 256, {200});
  testing::AddNoise(6, 6, &bright);
  for (int y = 0; y < 256; ++y) {
    std::copy_n(bright.data.begin() + y * 512 + 256, 256, image.data.begin() + y * 512 + 256);
  }
  const NoiseModel model = Measure(image);
  EXPECT_NEAR(model.At(40) / GradientNoiseFromPixelNoise(2, kNoiseSigma, 1), 1, 0.15);
  EXPECT_NEAR(model.At(200) / GradientNoiseFromPixelNoise(6, kNoiseSigma, 1), 1, 0.15);
  EXPECT_GT(model.At(120), model.At(40));
  EXPECT_LT(model.At(120), model.At(200));
}

TEST(MeasureNoise, NoiselessImageHasNone) {
  const NoiseModel model = Measure(testing::ConstantImage(64, 64, {77}));
  EXPECT_TRUE(model.noise.empty());
  EXPECT_EQ(model.At(10), 0);
  EXPECT_EQ(model.Mean(), 0);
}

}  // namespace
}  // namespace limn
