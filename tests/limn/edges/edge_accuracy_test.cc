// SPDX-License-Identifier: BSD-3-Clause
// Errors of edgels of blurred steps and bars, against what is possible.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "limn/edges/edge_detection.h"
#include "support/synthetic_image.h"

namespace limn {
namespace {

using Eigen::Vector2d;

// A straight line, and what is across it.
struct Line {
  Vector2d point;
  Vector2d normal;

  double Across(const Vector2d& px) const { return (px - point).dot(normal); }
  double Along(const Vector2d& px) const {
    const Vector2d offset = px - point;
    return normal.x() * offset.y() - normal.y() * offset.x();
  }
};

Line LineThroughMiddle(int width, int height, double angle_rad) {
  return {{0.5 * width - 0.3, 0.5 * height + 0.2}, {std::cos(angle_rad), std::sin(angle_rad)}};
}

// A step from 0 to 1 at 0, blurred by this.
double BlurredStep(double across_px, double blur_px) {
  return 0.5 * std::erfc(-across_px / (std::numbers::sqrt2 * blur_px));
}

// Gray levels by the distance from a line. A profile has the blur of the pixels in it.
template <typename Profile>
Image ProfileImage(int width, int height, const Line& line, const Profile& profile) {
  Image image = testing::ConstantImage(width, height, {0});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.data[y * width + x] = static_cast<float>(profile(line.Across(Vector2d(x, y))));
    }
  }
  return image;
}

constexpr double kStretchPx = 24;

// RMS over stretches of the mean error of a stretch's edgels, px. Stretches are those of steps of
// 60 gray levels in independent pictures.
double ErrorOfStretches(double blur_px, double noise) {
  double sum = 0;
  int count = 0;
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Line line = LineThroughMiddle(80, 320, 0.12 + 0.03 * seed);
    Image image = ProfileImage(
        80, 320, line, [&](double across_px) { return 80 + 60 * BlurredStep(across_px, blur_px); });
    testing::AddNoise(noise, seed + 1, &image);
    std::map<int, std::vector<double>> errors;
    for (const Edgel& edgel : DetectEdges(image, {}).edgels) {
      const double across_px = line.Across(edgel.position_px);
      if (std::abs(across_px) > 2 * blur_px + 1) continue;
      errors[static_cast<int>(std::floor(line.Along(edgel.position_px) / kStretchPx))].push_back(
          across_px);
    }
    for (const auto& [stretch, offsets] : errors) {
      if (offsets.size() < 0.8 * kStretchPx) continue;
      double mean = 0;
      for (const double offset : offsets) mean += offset / static_cast<double>(offsets.size());
      sum += mean * mean;
      ++count;
    }
  }
  EXPECT_GT(count, 30);
  return std::sqrt(sum / count);
}

// The Cramer-Rao bound: the least standard deviation of the place of a step along a stretch.
double LeastError(double blur_px, double contrast_to_noise) {
  return std::sqrt(2 * std::sqrt(std::numbers::pi) * blur_px / kStretchPx) / contrast_to_noise;
}

// What the maximum of the gradient at this scale errs by in white noise, over that bound.
double ExcessOfGradient(double blur_px, double sigma_px) {
  const double r = blur_px / sigma_px;
  return 0.61 * std::pow(1 + r * r, 1.5) / std::sqrt(r);
}

// An edge may be found at either scale.
TEST(EdgeAccuracy, StretchesOfStepsAgainstTheCramerRaoBound) {
  const EdgeDetectionOptions options;
  for (const double blur_px : {0.4, 0.7, 1.0, 1.5, 2.5, 4.0}) {
    for (const double contrast_to_noise : {3.0, 10.0, 30.0, 100.0}) {
      const double error_px = ErrorOfStretches(blur_px, 60 / contrast_to_noise);
      const double excess = error_px / LeastError(blur_px, contrast_to_noise);
      std::cout << "blur " << blur_px << " px, contrast " << contrast_to_noise
                << " times the noise: " << error_px << " px, " << excess << " times the bound\n";
      const double of_scales = std::max(ExcessOfGradient(blur_px, options.fine_sigma_px),
                                        ExcessOfGradient(blur_px, options.sigma_px));
      EXPECT_LT(excess, 1.2 * of_scales) << blur_px << " px, " << contrast_to_noise;
      EXPECT_GT(excess, 1) << blur_px << " px, " << contrast_to_noise;
    }
  }
}

// Errors of the edgels of the worse of the two edges of a bar, px of the image.
struct BarErrors {
  double mean = 0;
  double rms = 0;
};
BarErrors OfBar(double width_px, double angle_rad, double scale) {
  constexpr double kBlurPx = 0.45;
  constexpr int kSize = 96;
  const Line line = LineThroughMiddle(kSize, kSize, angle_rad);
  Image image = ProfileImage(kSize, kSize, line, [&](double across_px) {
    return 60 + 100 * (BlurredStep(across_px + 0.5 * width_px, kBlurPx) -
                       BlurredStep(across_px - 0.5 * width_px, kBlurPx));
  });
  testing::AddNoise(2, 5, &image);
  testing::Quantize(&image);
  image.scale.setConstant(scale);
  double sums[2] = {0, 0};
  double squares[2] = {0, 0};
  int counts[2] = {0, 0};
  for (const Edgel& edgel : DetectEdges(image, {}).edgels) {
    const Vector2d px = image.FromView(edgel.position_px);
    if (std::abs(line.Across(px)) > width_px || std::abs(line.Along(px)) > 35) continue;
    // The bar is bright: the normal of an edgel points into it.
    const int side = edgel.Normal().dot(line.normal) > 0 ? 0 : 1;
    const double error = line.Across(px) - (side == 0 ? -0.5 : 0.5) * width_px;
    sums[side] += error;
    squares[side] += error * error;
    ++counts[side];
  }
  BarErrors worst;
  for (int side = 0; side < 2; ++side) {
    EXPECT_GT(counts[side], 65 * scale) << width_px << " px at " << angle_rad;
    if (counts[side] == 0) continue;
    worst.mean = std::max(worst.mean, std::abs(sums[side] / counts[side]));
    worst.rms = std::max(worst.rms, std::sqrt(squares[side] / counts[side]));
  }
  return worst;
}

// Smoothing moves the edges of a narrow bar apart; views finer than their images are smoothed less.
TEST(EdgeAccuracy, BothEdgesOfNarrowBars) {
  for (const double angle_rad : {0.3, 1.1, 2.2}) {
    EXPECT_LT(OfBar(4, angle_rad, 1).mean, 0.02) << angle_rad;
    EXPECT_LT(OfBar(3, angle_rad, 1).mean, 0.1) << angle_rad;
    EXPECT_LT(OfBar(2.5, angle_rad, 1.5).mean, 0.04) << angle_rad;
    EXPECT_LT(OfBar(2.5, angle_rad, 2).mean, 0.02) << angle_rad;
    EXPECT_LT(OfBar(2, angle_rad, 2).mean, 0.06) << angle_rad;
    EXPECT_LT(OfBar(1.5, angle_rad, 2).mean, 0.2) << angle_rad;
    for (const double width_px : {2.0, 2.5, 3.0}) {
      const double as_stored = OfBar(width_px, angle_rad, 1).rms;
      const double finer = OfBar(width_px, angle_rad, 2).rms;
      std::cout << width_px << " px: RMS " << as_stored << " px, at twice the scale " << finer
                << " px\n";
      EXPECT_LT(finer, 0.1) << width_px << " px at " << angle_rad;
      if (width_px < 3) {
        EXPECT_LT(finer, 0.8 * as_stored) << width_px << " px at " << angle_rad;
      }
    }
  }
}

}  // namespace
}  // namespace limn
