#include "limn/edges/gaussian_derivatives.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "limn/util/float4.h"

namespace limn {
namespace {

// Taps are padded to whole blocks of so many, with zeros.
constexpr int kBlock = 8;

int GridHalfSize(double sigma_px) { return static_cast<int>(std::ceil(4 * sigma_px)); }

int SubpixelHalfSize(double sigma_px) { return static_cast<int>(std::ceil(4 * sigma_px + 0.5)); }

double Gaussian(double x, double sigma) {
  return std::exp(-0.5 * x * x / (sigma * sigma)) / (std::sqrt(2 * std::numbers::pi) * sigma);
}

// A symmetric and an antisymmetric kernel: the taps from the centre on.
struct HalfKernels {
  std::vector<float> even;
  std::vector<float> odd;
};

// The Gaussian, of sum 1, and its derivative.
HalfKernels GridKernels(double sigma_px) {
  const int half = GridHalfSize(sigma_px);
  double sum = 0;
  for (int k = -half; k <= half; ++k) sum += Gaussian(k, sigma_px);
  HalfKernels kernels;
  for (int k = 0; k <= half; ++k) {
    const double g = Gaussian(k, sigma_px) / sum;
    kernels.even.push_back(static_cast<float>(g));
    // Correlation, not convolution: the sign of the kernel is flipped.
    kernels.odd.push_back(static_cast<float>(g * k / (sigma_px * sigma_px)));
  }
  return kernels;
}

void StoreUpTo(int count, Float4 values, float* to) {
  std::memcpy(to, &values, sizeof(float) * std::clamp(count, 0, 4));
}

// even[x] = sum over k of kernels.even[|k|] row_at(k)[x], and so odd, unless it is null. Rows are
// read up to kBlock - 1 values beyond `count`.
template <typename RowAt>
void FilterAcross(const HalfKernels& kernels, int count, const RowAt& row_at, float* even,
                  float* odd) {
  const int half = static_cast<int>(kernels.even.size()) - 1;
  for (int x = 0; x < count; x += kBlock) {
    Float4 even_sum[2];
    Float4 odd_sum[2] = {Splat4(0), Splat4(0)};
    for (int v = 0; v < 2; ++v) even_sum[v] = kernels.even[0] * Load4(row_at(0) + x + 4 * v);
    for (int k = 1; k <= half; ++k) {
      const float* after = row_at(k) + x;
      const float* before = row_at(-k) + x;
      for (int v = 0; v < 2; ++v) {
        const Float4 a = Load4(after + 4 * v);
        const Float4 b = Load4(before + 4 * v);
        even_sum[v] += kernels.even[k] * (a + b);
        if (odd) odd_sum[v] += kernels.odd[k] * (a - b);
      }
    }
    for (int v = 0; v < 2; ++v) {
      StoreUpTo(count - x - 4 * v, even_sum[v], even + x + 4 * v);
      if (odd) StoreUpTo(count - x - 4 * v, odd_sum[v], odd + x + 4 * v);
    }
  }
}

// The last rows of a plane, filtered along x: what the filter across them needs.
class RowRing {
 public:
  RowRing(int num_rows, int width) : num_rows_(num_rows), stride_(width + kBlock) {
    values_.resize(static_cast<size_t>(num_rows_) * stride_);
  }
  // y >= 0.
  float* Row(int y) { return values_.data() + static_cast<size_t>(y % num_rows_) * stride_; }

 private:
  int num_rows_;
  int stride_;
  std::vector<float> values_;
};

}  // namespace

int GaussianPadding(double sigma_px) { return SubpixelHalfSize(sigma_px) + kBlock; }

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
  const HalfKernels kernels = GridKernels(sigma_px);
  const int half = GridHalfSize(sigma_px);
  const int width = plane.width;
  const int height = plane.height;
  const size_t size = static_cast<size_t>(width) * height;
  GradientField field{width, height, std::vector<float>(size), std::vector<float>(size),
                      std::vector<float>(size)};
  RowRing smooth(2 * half + 1, width);
  RowRing derived(2 * half + 1, width);
  for (int last = 0; last < height + 2 * half; ++last) {
    const float* source = plane.Row(last - half);
    FilterAcross(
        kernels, width, [&](int k) { return source + k; }, smooth.Row(last), derived.Row(last));
    const int centre = last - half;
    if (centre < half) continue;
    const size_t out = static_cast<size_t>(centre - half) * width;
    FilterAcross(
        kernels, width, [&](int k) { return smooth.Row(centre + k); }, field.smooth.data() + out,
        field.dy.data() + out);
    FilterAcross(
        kernels, width, [&](int k) { return derived.Row(centre + k); }, field.dx.data() + out,
        nullptr);
  }
  return field;
}

SubpixelDerivatives::SubpixelDerivatives(const PaddedPlane& plane, double sigma_px)
    : plane_(plane), half_size_(SubpixelHalfSize(sigma_px)) {
  const int taps = 2 * half_size_ + 1;
  row_size_ = (taps + kBlock - 1) / kBlock * kBlock;
  kernels_.assign(static_cast<size_t>(kNodesPerPx + 1) * 4 * row_size_, 0.f);
  const double inverse_variance = 1 / (sigma_px * sigma_px);
  for (int node = 0; node <= kNodesPerPx; ++node) {
    const double fraction = static_cast<double>(node) / kNodesPerPx - 0.5;
    float* kernel = kernels_.data() + static_cast<size_t>(node) * 4 * row_size_;
    for (int i = 0; i < taps; ++i) {
      // Derivatives with respect to the position of the kernel (u = pixel - position).
      const double u = i - half_size_ - fraction;
      const double v = u * inverse_variance;
      const double g = Gaussian(u, sigma_px);
      kernel[i] = static_cast<float>(g);
      kernel[row_size_ + i] = static_cast<float>(g * v);
      kernel[2 * row_size_ + i] = static_cast<float>(g * (v * v - inverse_variance));
      kernel[3 * row_size_ + i] = static_cast<float>(g * v * (v * v - 3 * inverse_variance));
    }
  }
}

const float* SubpixelDerivatives::KernelAt(double fraction) const {
  const int node = static_cast<int>((fraction + 0.5) * kNodesPerPx + 0.5);
  return kernels_.data() + static_cast<size_t>(node) * 4 * row_size_;
}

Jet SubpixelDerivatives::At(double x, double y) const {
  const int column = static_cast<int>(x + 0.5);
  const int row = static_cast<int>(y + 0.5);
  const float* kernel_x = KernelAt(x - column);
  const float* kernel_y = KernelAt(y - row);
  const int taps = 2 * half_size_ + 1;

  // Truncated, shifted derivative kernels do not sum to zero exactly; subtracting the level of the
  // centre pixel keeps a bright plane from leaking into the derivatives.
  const float level = plane_.Row(row)[column];
  // sums[a][b]: derived a times along y, b times along x.
  Float4 sums[4][4] = {};
  for (int i = 0; i < row_size_; i += kBlock) {
    // Down the columns first, a block of them at a time, which stays in registers.
    const float* values = plane_.Row(row - half_size_) + column - half_size_ + i;
    Float4 down[4][2] = {};
    for (int j = 0; j < taps; ++j, values += plane_.stride) {
      const Float4 here[2] = {Load4(values) - level, Load4(values + 4) - level};
      for (int a = 0; a < 4; ++a) {
        const float tap = kernel_y[a * row_size_ + j];
        down[a][0] += tap * here[0];
        down[a][1] += tap * here[1];
      }
    }
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; a + b < 4; ++b) {
        const float* along = kernel_x + b * row_size_ + i;
        sums[a][b] += down[a][0] * Load4(along) + down[a][1] * Load4(along + 4);
      }
    }
  }
  Jet jet;
  jet.value = Sum4(sums[0][0]) + level;
  jet.x = Sum4(sums[0][1]);
  jet.y = Sum4(sums[1][0]);
  jet.xx = Sum4(sums[0][2]);
  jet.xy = Sum4(sums[1][1]);
  jet.yy = Sum4(sums[2][0]);
  jet.xxx = Sum4(sums[0][3]);
  jet.xxy = Sum4(sums[1][2]);
  jet.xyy = Sum4(sums[2][1]);
  jet.yyy = Sum4(sums[3][0]);
  return jet;
}

}  // namespace limn
