#include "limn/edges/gaussian_derivatives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace limn {
namespace {

// Enough for sigma = 5 px, the largest the options allow.
constexpr int kMaxTaps = 48;

int GridHalfSize(double sigma_px) { return static_cast<int>(std::ceil(4 * sigma_px)); }

int SubpixelHalfSize(double sigma_px) { return static_cast<int>(std::ceil(4 * sigma_px + 0.5)); }

double Gaussian(double x, double sigma) {
  return std::exp(-0.5 * x * x / (sigma * sigma)) / (std::sqrt(2 * std::numbers::pi) * sigma);
}

// out[x] = sum over k of taps[half + k] * rows(k)[x]; the loop over x is the inner one, to
// vectorise.
template <typename RowAt>
void AccumulateTaps(const std::vector<float>& taps, int half, int count, const RowAt& row_at,
                    float* out) {
  std::fill(out, out + count, 0.f);
  for (int k = -half; k <= half; ++k) {
    const float tap = taps[half + k];
    const float* row = row_at(k);
    for (int x = 0; x < count; ++x) out[x] += tap * row[x];
  }
}

}  // namespace

int GaussianPadding(double sigma_px) { return SubpixelHalfSize(sigma_px) + 1; }

PaddedPlane MakePaddedPlane(const std::vector<float>& values, int width, int height, int pad) {
  PaddedPlane plane;
  plane.width = width;
  plane.height = height;
  plane.pad = pad;
  plane.stride = width + 2 * pad;
  plane.values.resize(static_cast<size_t>(plane.stride) * (height + 2 * pad));
  for (int y = -pad; y < height + pad; ++y) {
    const float* source = values.data() + static_cast<size_t>(std::clamp(y, 0, height - 1)) * width;
    float* row = plane.Row(y);
    std::fill(row - pad, row, source[0]);
    std::copy(source, source + width, row);
    std::fill(row + width, row + width + pad, source[width - 1]);
  }
  return plane;
}

GradientField SmoothedGradient(const PaddedPlane& plane, double sigma_px) {
  const int half = GridHalfSize(sigma_px);
  std::vector<float> smooth(2 * half + 1);
  std::vector<float> derive(2 * half + 1);
  double sum = 0;
  for (int k = -half; k <= half; ++k) sum += Gaussian(k, sigma_px);
  for (int k = -half; k <= half; ++k) {
    const double g = Gaussian(k, sigma_px) / sum;
    smooth[half + k] = static_cast<float>(g);
    // Correlation, not convolution: the sign of the kernel is flipped.
    derive[half + k] = static_cast<float>(g * k / (sigma_px * sigma_px));
  }

  const int width = plane.width;
  const int height = plane.height;
  const size_t size = static_cast<size_t>(width) * height;
  const size_t tall = static_cast<size_t>(width) * (height + 2 * half);
  std::vector<float> rows_smooth(tall);
  std::vector<float> rows_derived(tall);
  for (int y = -half; y < height + half; ++y) {
    const auto shifted = [&](int k) { return plane.Row(y) + k; };
    const size_t offset = static_cast<size_t>(y + half) * width;
    AccumulateTaps(smooth, half, width, shifted, rows_smooth.data() + offset);
    AccumulateTaps(derive, half, width, shifted, rows_derived.data() + offset);
  }

  GradientField field{width, height, std::vector<float>(size), std::vector<float>(size),
                      std::vector<float>(size)};
  for (int y = 0; y < height; ++y) {
    const auto offset = [&](int k) { return static_cast<size_t>(y + half + k) * width; };
    const size_t out = static_cast<size_t>(y) * width;
    AccumulateTaps(
        smooth, half, width, [&](int k) { return rows_derived.data() + offset(k); },
        field.dx.data() + out);
    const auto smooth_row = [&](int k) { return rows_smooth.data() + offset(k); };
    AccumulateTaps(derive, half, width, smooth_row, field.dy.data() + out);
    AccumulateTaps(smooth, half, width, smooth_row, field.smooth.data() + out);
  }
  return field;
}

SubpixelDerivatives::SubpixelDerivatives(const PaddedPlane& plane, double sigma_px)
    : plane_(plane), sigma_px_(sigma_px), half_size_(SubpixelHalfSize(sigma_px)) {
  for (int k = -half_size_; k <= half_size_; ++k) {
    centred_gaussian_.push_back(Gaussian(k, sigma_px));
  }
}

void SubpixelDerivatives::ShiftedKernel(double fraction, Tap* taps) const {
  // G(k - f) = G(k) exp(k f / s^2) exp(-f^2 / 2 s^2): two exponentials instead of one per tap.
  const double inverse_variance = 1 / (sigma_px_ * sigma_px_);
  const double ratio = std::exp(fraction * inverse_variance);
  double factor =
      std::exp(-0.5 * fraction * fraction * inverse_variance) / std::pow(ratio, half_size_);
  for (int k = -half_size_; k <= half_size_; ++k) {
    const double g = centred_gaussian_[k + half_size_] * factor;
    factor *= ratio;
    // Derivatives with respect to the position of the kernel (u = pixel - position).
    const double u = k - fraction;
    const double v = u * inverse_variance;
    Tap& tap = taps[k + half_size_];
    tap.order[0] = static_cast<float>(g);
    tap.order[1] = static_cast<float>(g * v);
    tap.order[2] = static_cast<float>(g * (v * v - inverse_variance));
    tap.order[3] = static_cast<float>(g * v * (v * v - 3 * inverse_variance));
  }
}

Jet SubpixelDerivatives::At(double x, double y) const {
  const int column = static_cast<int>(std::lround(x));
  const int row = static_cast<int>(std::lround(y));
  std::array<Tap, kMaxTaps> kernel_x;
  std::array<Tap, kMaxTaps> kernel_y;
  ShiftedKernel(x - column, kernel_x.data());
  ShiftedKernel(y - row, kernel_y.data());

  // Truncated, shifted derivative kernels do not sum to zero exactly; subtracting the level of the
  // centre pixel keeps a bright plane from leaking into the derivatives.
  const float level = plane_.Row(row)[column];
  const int taps = 2 * half_size_ + 1;
  Jet jet;
  for (int j = 0; j < taps; ++j) {
    const float* values = plane_.Row(row + j - half_size_) + column - half_size_;
    float along_x[4] = {0, 0, 0, 0};
    for (int i = 0; i < taps; ++i) {
      const float value = values[i] - level;
      for (int order = 0; order < 4; ++order) along_x[order] += value * kernel_x[i].order[order];
    }
    const float* k = kernel_y[j].order;
    jet.value += along_x[0] * k[0];
    jet.x += along_x[1] * k[0];
    jet.y += along_x[0] * k[1];
    jet.xx += along_x[2] * k[0];
    jet.xy += along_x[1] * k[1];
    jet.yy += along_x[0] * k[2];
    jet.xxx += along_x[3] * k[0];
    jet.xxy += along_x[2] * k[1];
    jet.xyy += along_x[1] * k[2];
    jet.yyy += along_x[0] * k[3];
  }
  jet.value += level;
  return jet;
}

}  // namespace limn
