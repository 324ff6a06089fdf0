// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/grid_maxima.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "limn/util/angles.h"

namespace limn {
namespace {

constexpr double kSigma = 1.5;
constexpr int kSize = 41;

// A sharp step through the point (20.3, 19.9), sampled at a blur of 0.7 px.
GradientField StepGradient(double normal_x, double normal_y) {
  std::vector<float> values;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double offset = (x - 20.3) * normal_x + (y - 19.9) * normal_y;
      values.push_back(static_cast<float>(100 + 30 * std::erf(offset)));
    }
  }
  return SmoothedGradient(MakePaddedPlane(values, kSize, kSize, GaussianPadding(kSigma, 1)),
                          GaussianKernels(kSigma, 1), kSize, kSize);
}

std::vector<int32_t> Row(const GradientField& gradient, int y, float lowest) {
  std::vector<int32_t> near_maximum(gradient.width, 1);
  FindGridMaxima(gradient, GradientMagnitude(gradient), y, lowest, near_maximum.data());
  return near_maximum;
}

TEST(FindGridMaxima, PixelsBesideAStep) {
  for (int degrees = 0; degrees < 360; degrees += 15) {
    const double angle = degrees * kDeg;
    const double nx = std::cos(angle);
    const double ny = std::sin(angle);
    const GradientField gradient = StepGradient(nx, ny);
    for (int y = 8; y < kSize - 8; ++y) {
      const std::vector<int32_t> near_maximum = Row(gradient, y, 1);
      for (int x = 8; x < kSize - 8; ++x) {
        // The step from the pixel to the edge, along the axis that is nearer to the gradient.
        const double offset = std::abs((x - 20.3) * nx + (y - 19.9) * ny);
        const double step = offset * std::max(std::abs(nx), std::abs(ny));
        if (step < 0.7) {
          EXPECT_NE(near_maximum[x], 0) << degrees << ": " << x << ", " << y;
        }
        if (step > 1.1) {
          EXPECT_EQ(near_maximum[x], 0) << degrees << ": " << x << ", " << y;
        }
      }
    }
  }
}

TEST(FindGridMaxima, NothingWeakAndNothingAtTheBorder) {
  const GradientField gradient = StepGradient(0, 1);
  const std::vector<int32_t> on_step = Row(gradient, 20, 1);
  EXPECT_EQ(on_step.front(), 0);
  EXPECT_EQ(on_step.back(), 0);
  EXPECT_EQ(std::count(on_step.begin(), on_step.end(), 0), 2);
  const std::vector<int32_t> too_weak = Row(gradient, 20, 100);
  EXPECT_EQ(std::count(too_weak.begin(), too_weak.end(), 0), kSize);
}

}  // namespace
}  // namespace limn
