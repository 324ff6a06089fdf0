// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/edge_blur.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "limn/edges/edge_refinement.h"
#include "limn/edges/edge_signal.h"
#include "limn/edges/grid_maxima.h"

namespace limn {
namespace {

constexpr double kSigmaPx = 1;
// Weakest edge that counts, noise and gray levels per px: noise changes the blur of weaker ones.
constexpr double kNoiseFactor = 20;
constexpr double kMinStrength = 5;
constexpr int kMarginPx = 8;
constexpr int kRowStep = 3;
constexpr size_t kLeastEdgels = 100;

bool IsMasked(const Image& image, int x, int y) {
  return !image.mask.empty() && image.mask[static_cast<size_t>(y) * image.width + x] == 0;
}

}  // namespace

std::optional<double> MeasureEdgeBlur(const Image& image) {
  const EdgeSignal signal =
      PrepareSignal(SearchedChannels(image, EdgeChannel::kGreen), image, kSigmaPx);
  const RefinementContext context{1, kSigmaPx, signal.noise, kNoiseFactor, kMinStrength};
  const std::vector<SubpixelDerivatives> derivatives = {
      {signal.planes[0], *signal.kernels, Eigen::Array2d::Ones()}};
  std::vector<double> blurs;
  std::vector<int32_t> near_maximum(image.width);
  for (int y = kMarginPx; y < image.height - kMarginPx; y += kRowStep) {
    FindGridMaxima(signal.gradient, signal.magnitude, y, kMinStrength, near_maximum.data());
    for (int x = kMarginPx; x < image.width - kMarginPx; ++x) {
      if (!near_maximum[x] || IsMasked(image, x, y)) continue;
      if (const auto edgel = RefineEdgel(derivatives, x, y, context)) {
        blurs.push_back(edgel->blur_px);
      }
    }
  }
  if (blurs.size() < kLeastEdgels) return std::nullopt;
  const auto middle = blurs.begin() + static_cast<std::ptrdiff_t>(blurs.size() / 2);
  std::nth_element(blurs.begin(), middle, blurs.end());
  return *middle;
}

}  // namespace limn
