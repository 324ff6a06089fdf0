// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/edge_profile.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/kinds/step_image.h"
#include "support/synthetic_image.h"

namespace limn {
namespace {

using testing::GaussianStep;
using testing::ImageOf;
using testing::Mix;
using testing::StepColor;

constexpr StepColor kDark = {40, 50, 60};
constexpr StepColor kBright = {160, 140, 120};
const Eigen::Vector2d kMiddle(30.3, 29.6);

// Bright on the side of (sin t, -cos t), with this blur, px; the step is `shift` beside the middle.
Eigen::Vector2d Along(double direction_rad) {
  return {std::cos(direction_rad), std::sin(direction_rad)};
}

Image StepAlong(double direction_rad, double blur_px, double shift = 0) {
  const Eigen::Vector2d left(std::sin(direction_rad), -std::cos(direction_rad));
  return ImageOf(60, 60, [&](double x, double y) {
    const double distance = (Eigen::Vector2d(x, y) - kMiddle).dot(left) - shift;
    return Mix(kDark, kBright, GaussianStep(distance / blur_px));
  });
}

// Interpolation between pixels (variance 1/6 px^2) and differences over one px (1/12) widen a step.
// It ends where the slope is a tenth of the largest: 3 % of its contrast lie beyond.
double WidthOf(double blur_px) { return 0.97 * std::sqrt(blur_px * blur_px + 0.25); }

TEST(EdgeProfileTest, WidthIsThatOfTheBlurInAnyDirection) {
  for (const double direction : {0.0, 0.4, 1.2, 2.0, -1.0, -2.8}) {
    for (const double blur : {0.6, 1.0, 1.5, 2.5}) {
      const auto profile = MeasureProfile(StepAlong(direction, blur), kMiddle, Along(direction));
      ASSERT_TRUE(profile);
      // Half a step of 0.5 px between the places of the profile, at either end of the step.
      EXPECT_NEAR(profile->width_px, WidthOf(blur), 0.08 * WidthOf(blur))
          << direction << ' ' << blur;
    }
  }
}

TEST(EdgeProfileTest, SidesHaveTheirColors) {
  for (const double direction : {0.3, 0.3 + M_PI}) {
    const auto profile = MeasureProfile(StepAlong(0.3, 1), kMiddle, Along(direction));
    ASSERT_TRUE(profile);
    const bool is_turned = direction > M_PI;
    for (int c = 0; c < 3; ++c) {
      const double tolerance = 0.03 * std::abs(kBright[c] - kDark[c]);
      EXPECT_NEAR((is_turned ? profile->right : profile->left)[c], kBright[c], tolerance);
      EXPECT_NEAR((is_turned ? profile->left : profile->right)[c], kDark[c], tolerance);
    }
  }
}

TEST(EdgeProfileTest, NoiseIsAveragedAlongTheEdge) {
  Image image = StepAlong(0.7, 1);
  testing::AddNoise(4, 7, &image);
  const auto profile = MeasureProfile(image, kMiddle, Along(0.7));
  ASSERT_TRUE(profile);
  // A slope over 1 px of 7 px along the edge: noise 4 * sqrt(2 / 7) of about 42 gray levels per px.
  EXPECT_NEAR(profile->width_px, WidthOf(1), 0.25 * WidthOf(1));
}

TEST(EdgeProfileTest, GrayImagesHaveThreeEqualChannels) {
  const Image color = StepAlong(0.2, 1);
  Image gray = {color.width, color.height, 1, {}, {}};
  for (size_t i = 0; i < color.data.size(); i += 3) gray.data.push_back(color.data[i + 1]);
  const auto profile = MeasureProfile(gray, kMiddle, Along(0.2));
  ASSERT_TRUE(profile);
  EXPECT_NEAR(profile->contrast, kBright[1] - kDark[1], 0.06 * (kBright[1] - kDark[1]));
  EXPECT_EQ(profile->left[0], profile->left[1]);
  EXPECT_EQ(profile->left[2], profile->left[1]);
}

TEST(EdgeProfileTest, ThereIsNoneWithoutAStepAtThePlace) {
  EXPECT_FALSE(MeasureProfile(testing::ConstantImage(60, 60, {90, 90, 90}), kMiddle, Along(0)));
  EXPECT_FALSE(MeasureProfile(StepAlong(0.7, 1, 4), kMiddle, Along(0.7)));
  EXPECT_TRUE(MeasureProfile(StepAlong(0.7, 1, 0.7), kMiddle, Along(0.7)));
}

TEST(EdgeProfileTest, ThereIsNoneAtTheBorderOrAtMaskedPixels) {
  Image image = StepAlong(0, 1);
  EXPECT_FALSE(MeasureProfile(image, {30, 6}, Along(0)));
  EXPECT_FALSE(MeasureProfile(image, {2, 29.6}, Along(0)));
  EXPECT_FALSE(MeasureProfile(image, {NAN, 29.6}, Along(0)));
  image.mask.assign(60 * 60, 1);
  EXPECT_TRUE(MeasureProfile(image, kMiddle, Along(0)));
  for (int x = 0; x < 60; ++x) image.mask[36 * 60 + x] = 0;
  EXPECT_FALSE(MeasureProfile(image, kMiddle, Along(0)));
}

}  // namespace
}  // namespace limn
