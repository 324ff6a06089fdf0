// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <functional>

#include "limn/model/image.h"

namespace limn::testing {

using StepColor = std::array<double, 3>;

// The integral of a Gaussian of standard deviation 1.
inline double GaussianStep(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

// An image of 3 channels with the given color at every pixel center.
inline Image ImageOf(int width, int height,
                     const std::function<StepColor(double x, double y)>& color_at) {
  Image image = {width, height, 3, {}, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (const double value : color_at(x, y)) image.data.push_back(static_cast<float>(value));
    }
  }
  return image;
}

inline StepColor Mix(const StepColor& from, const StepColor& to, double share) {
  StepColor color;
  for (int c = 0; c < 3; ++c) color[c] = from[c] + share * (to[c] - from[c]);
  return color;
}

}  // namespace limn::testing
