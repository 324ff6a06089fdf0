#include "limn/edges/gradient_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace limn {
namespace {

constexpr int kBlockPx = 32;
constexpr double kPixelQuantile = 0.3;
constexpr double kBlockQuantile = 0.4;
// Rounding to integers alone is noise of 0.29 grey levels; half of that is left where an image is
// partly constant.
constexpr double kQuietestPixelNoise = 0.14;

double QuantileOf(std::vector<float>* values, double quantile) {
  const auto nth =
      values->begin() + static_cast<std::ptrdiff_t>(quantile * (values->size() - 1) + 0.5);
  std::nth_element(values->begin(), nth, values->end());
  return *nth;
}

// Squared gradient magnitudes of a block; every second pixel is enough, neighbours are correlated.
void CollectBlock(const GradientField& gradient, int x0, int y0, std::vector<float>* values) {
  values->clear();
  const int x1 = std::min(x0 + kBlockPx, gradient.width);
  const int y1 = std::min(y0 + kBlockPx, gradient.height);
  for (int y = y0; y < y1; y += 2) {
    for (int x = x0; x < x1; x += 2) {
      const size_t i = static_cast<size_t>(y) * gradient.width + x;
      values->push_back(gradient.dx[i] * gradient.dx[i] + gradient.dy[i] * gradient.dy[i]);
    }
  }
}

}  // namespace

double GradientNoiseFromPixelNoise(double pixel_noise, double sigma_px) {
  return pixel_noise / (std::sqrt(8 * std::numbers::pi) * sigma_px * sigma_px);
}

double EstimateGradientNoise(const GradientField& gradient, double sigma_px) {
  const double quietest = GradientNoiseFromPixelNoise(kQuietestPixelNoise, sigma_px);
  const double rayleigh = -2 * std::log(1 - kPixelQuantile);
  std::vector<float> of_blocks;
  std::vector<float> values;
  for (int y = 0; y < gradient.height; y += kBlockPx) {
    for (int x = 0; x < gradient.width; x += kBlockPx) {
      CollectBlock(gradient, x, y, &values);
      const double noise = std::sqrt(QuantileOf(&values, kPixelQuantile) / rayleigh);
      if (noise >= quietest) of_blocks.push_back(static_cast<float>(noise));
    }
  }
  return of_blocks.empty() ? 0 : QuantileOf(&of_blocks, kBlockQuantile);
}

}  // namespace limn
