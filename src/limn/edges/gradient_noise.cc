// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/gradient_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

namespace limn {
namespace {

constexpr int kBlockPx = 32;
// Quantile of gradient magnitudes in a block, and of blocks; in simulated noise the latter is this
// much below the center of the blocks' scatter.
constexpr double kPixelQuantile = 0.3;
constexpr double kGradientBlockQuantile = 0.15;
constexpr double kGradientBlockBias = 0.93;
constexpr double kWhiteBlockQuantile = 0.3;
// Rounding to integers alone is noise of 0.29 gray levels; half of that is left where an image is
// partly constant.
constexpr double kQuietestPixelNoise = 0.14;
// The estimate is at most this factor times the white noise, with this much pixel noise added (as
// variances) that compression may have hidden.
constexpr double kMaxOverWhiteNoise = 1.15;
constexpr double kHiddenPixelNoise = 3.5;
constexpr size_t kMaxGroups = 6;
constexpr size_t kMinBlocksPerGroup = 20;

double QuantileOf(std::vector<float>* values, double quantile) {
  const auto nth =
      values->begin() + static_cast<std::ptrdiff_t>(quantile * (values->size() - 1) + 0.5);
  std::nth_element(values->begin(), nth, values->end());
  return *nth;
}

struct Block {
  int x0, y0, x1, y1;
};

// The pixel of the gradient at the center of one of the plane.
size_t IndexAt(const PaddedPlane& plane, const GradientField& gradient, int x, int y) {
  const size_t row = (2 * static_cast<size_t>(y) + 1) * gradient.height / (2 * plane.height);
  return row * gradient.width +
         (2 * static_cast<size_t>(x) + 1) * gradient.width / (2 * plane.width);
}

double RayleighNoise(const PaddedPlane& plane, const GradientField& gradient, const Block& block) {
  // Every second pixel is enough, neighbors are correlated.
  std::vector<float> squared;
  squared.reserve(kBlockPx * kBlockPx / 4);
  for (int y = block.y0; y < block.y1; y += 2) {
    for (int x = block.x0; x < block.x1; x += 2) {
      const size_t i = IndexAt(plane, gradient, x, y);
      squared.push_back(gradient.dx[i] * gradient.dx[i] + gradient.dy[i] * gradient.dy[i]);
    }
  }
  return std::sqrt(QuantileOf(&squared, kPixelQuantile) / (-2 * std::log(1 - kPixelQuantile)));
}

// Mean absolute response to the outer product of (1, -2, 1) with itself, whose norm is 6.
double WhitePixelNoise(const PaddedPlane& plane, const Block& block) {
  double sum = 0;
  for (int y = block.y0; y < block.y1; ++y) {
    const float* above = plane.Row(y - 1);
    const float* here = plane.Row(y);
    const float* below = plane.Row(y + 1);
    float row_sum = 0;
    for (int x = block.x0; x < block.x1; ++x) {
      row_sum += std::abs(above[x - 1] + above[x + 1] + below[x - 1] + below[x + 1] -
                          2 * (above[x] + here[x - 1] + here[x + 1] + below[x]) + 4 * here[x]);
    }
    sum += row_sum;
  }
  const double count = static_cast<double>(block.x1 - block.x0) * (block.y1 - block.y0);
  return std::sqrt(0.5 * std::numbers::pi) * sum / (6 * count);
}

float MeanLevel(const PaddedPlane& plane, const GradientField& gradient, const Block& block) {
  double sum = 0;
  for (int y = block.y0; y < block.y1; ++y) {
    for (int x = block.x0; x < block.x1; ++x)
      sum += gradient.smooth[IndexAt(plane, gradient, x, y)];
  }
  return static_cast<float>(sum / ((block.x1 - block.x0) * (block.y1 - block.y0)));
}

// What a block tells.
struct Sample {
  float level;
  float rayleigh;
  float white;
};

double NoiseOfGroup(std::span<const Sample> group, double sigma_px, double scale) {
  std::vector<float> rayleigh;
  std::vector<float> white;
  for (const Sample& sample : group) {
    rayleigh.push_back(sample.rayleigh);
    white.push_back(sample.white);
  }
  const double upper = QuantileOf(&rayleigh, kGradientBlockQuantile) / kGradientBlockBias;
  const double white_noise = QuantileOf(&white, kWhiteBlockQuantile);
  const double highest = std::hypot(kMaxOverWhiteNoise * white_noise, kHiddenPixelNoise);
  return std::min(upper, GradientNoiseFromPixelNoise(highest, sigma_px, scale));
}

}  // namespace

double GradientNoiseFromPixelNoise(double pixel_noise, double sigma_px, double scale) {
  return pixel_noise * scale / (std::sqrt(8 * std::numbers::pi) * sigma_px * sigma_px);
}

NoiseModel MeasureNoise(const PaddedPlane& plane, const GradientField& gradient, double sigma_px) {
  const double scale = static_cast<double>(gradient.width) / plane.width;
  const double quietest = GradientNoiseFromPixelNoise(kQuietestPixelNoise, sigma_px, scale);
  std::vector<Sample> samples;
  for (int y = 0; y < plane.height; y += kBlockPx) {
    for (int x = 0; x < plane.width; x += kBlockPx) {
      const Block block{x, y, std::min(x + kBlockPx, plane.width),
                        std::min(y + kBlockPx, plane.height)};
      const double noise = RayleighNoise(plane, gradient, block);
      if (noise < quietest) continue;
      samples.push_back({MeanLevel(plane, gradient, block), static_cast<float>(noise),
                         static_cast<float>(WhitePixelNoise(plane, block))});
    }
  }
  std::stable_sort(samples.begin(), samples.end(),
                   [](const Sample& a, const Sample& b) { return a.level < b.level; });
  const size_t groups =
      std::clamp<size_t>(samples.size() / kMinBlocksPerGroup, samples.empty() ? 0 : 1, kMaxGroups);
  NoiseModel model;
  for (size_t g = 0; g < groups; ++g) {
    const auto begin = samples.begin() + static_cast<std::ptrdiff_t>(g * samples.size() / groups);
    const auto end =
        samples.begin() + static_cast<std::ptrdiff_t>((g + 1) * samples.size() / groups);
    model.level.push_back(begin[(end - begin) / 2].level);
    model.noise.push_back(NoiseOfGroup({begin, end}, sigma_px, scale));
  }
  return model;
}

double NoiseModel::At(double gray_level) const {
  if (level.empty()) return 0;
  const auto above = std::upper_bound(level.begin(), level.end(), gray_level);
  if (above == level.begin()) return noise.front();
  if (above == level.end()) return noise.back();
  const auto i = above - level.begin();
  const double share = (gray_level - level[i - 1]) / (level[i] - level[i - 1]);
  return (1 - share) * noise[i - 1] + share * noise[i];
}

double NoiseModel::Mean() const {
  if (noise.empty()) return 0;
  return std::accumulate(noise.begin(), noise.end(), 0.0) / static_cast<double>(noise.size());
}

}  // namespace limn
