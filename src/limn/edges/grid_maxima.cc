// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/grid_maxima.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "limn/util/float4.h"

namespace limn {
namespace {

// The refinement goes no farther than 0.7 px; three grid values err by less than the rest.
constexpr float kMaxStepPx = 0.8f;

// Four pixels, of which here[0] is the magnitude of the first.
auto NearMaximum(const float* here, std::ptrdiff_t width, Float4 dx, Float4 dy, float lowest) {
  // The line leaves the neighborhood between a pixel on an axis and one on a diagonal.
  const Float4 length_x = Abs4(dx);
  const Float4 length_y = Abs4(dy);
  const auto steep = length_y > length_x;
  const auto rising = dx * dy < Splat4(0);  // to the upper right, as y points down
  const Float4 share = Min4(length_x, length_y) / Max4(length_x, length_y);
  const Float4 upper_right = Load4(here - width + 1);
  const Float4 lower_left = Load4(here + width - 1);
  const Float4 axis_after = steep ? Load4(here + width) : Load4(here + 1);
  const Float4 axis_before = steep ? Load4(here - width) : Load4(here - 1);
  const Float4 rising_after = steep ? lower_left : upper_right;
  const Float4 rising_before = steep ? upper_right : lower_left;
  const Float4 diagonal_after = rising ? rising_after : Load4(here + width + 1);
  const Float4 diagonal_before = rising ? rising_before : Load4(here - width - 1);
  const Float4 after = axis_after + share * (diagonal_after - axis_after);
  const Float4 before = axis_before + share * (diagonal_before - axis_before);

  const Float4 center = Load4(here);
  const Float4 bend = after + before - 2.0f * center;
  const Float4 slope = 0.5f * (after - before);
  // The step, -(slope / center) / (bend / center - (slope / center)^2), is at most kMaxStepPx.
  const Float4 curvature = slope * slope - bend * center;
  const auto is_near = Abs4(slope * center) <= kMaxStepPx * curvature;
  return is_near & (bend < Splat4(0)) & (center > Splat4(lowest));
}

}  // namespace

std::vector<float> GradientMagnitude(const GradientField& gradient) {
  std::vector<float> magnitude(gradient.dx.size());
  for (size_t i = 0; i < magnitude.size(); ++i) {
    const float dx = gradient.dx[i];
    const float dy = gradient.dy[i];
    magnitude[i] = std::sqrt(dx * dx + dy * dy);
  }
  return magnitude;
}

void FindGridMaxima(const GradientField& gradient, const std::vector<float>& magnitude, int y,
                    float lowest, int32_t* near_maximum) {
  const int width = gradient.width;
  std::fill(near_maximum, near_maximum + width, 0);
  // The last four overlap those before.
  const int last = width - 5;
  for (int x = 1; x <= last; x = x < last ? std::min(x + 4, last) : x + 1) {
    const size_t i = static_cast<size_t>(y) * width + x;
    const auto found = NearMaximum(magnitude.data() + i, width, Load4(gradient.dx.data() + i),
                                   Load4(gradient.dy.data() + i), lowest);
    std::memcpy(near_maximum + x, &found, sizeof(found));
  }
}

}  // namespace limn
