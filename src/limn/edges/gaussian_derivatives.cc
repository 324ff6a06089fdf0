#include "limn/edges/gaussian_derivatives.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "limn/util/float4.h"
#include "limn/util/float8.h"

namespace limn {
namespace {

// Taps are padded with zeros to whole blocks of this size.
constexpr int kBlock = 8;

int GridHalfSize(double sigma_px) { return static_cast<int>(std::ceil(4 * sigma_px)); }

int SubpixelHalfSize(double sigma_px) { return static_cast<int>(std::ceil(4 * sigma_px + 0.5)); }

double Gaussian(double x, double sigma) {
  return std::exp(-0.5 * x * x / (sigma * sigma)) / (std::sqrt(2 * std::numbers::pi) * sigma);
}

// A symmetric and an antisymmetric kernel: the taps from the center on.
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

// What a filter reads and writes. Rows are read up to kBlock - 1 values beyond the count.
struct FilterRows {
  const float* const* center;  // row k of the input is center[k]
  int count;                   // values of a row
  float* even;
  float* odd;  // or null
};

LIMN_INLINE_KERNEL void StoreUpTo(int count, const Float8& values, float* to) {
  if (count >= kBlock) {
    Store8(values, to);
  } else {
    std::memcpy(to, &values, sizeof(float) * count);
  }
}

// even[x] = sum over k of kernels.even[|k|] center[k][x], and so odd.
LIMN_INLINE_KERNEL void Filter(const HalfKernels& kernels, const FilterRows& rows) {
  const int half = static_cast<int>(kernels.even.size()) - 1;
  const float* even_taps = kernels.even.data();
  const float* odd_taps = kernels.odd.data();
  for (int x = 0; x < rows.count; x += kBlock) {
    Float8 here, before, after;
    Load8(rows.center[0] + x, &here);
    Float8 even = even_taps[0] * here;
    Float8 odd = {};
    for (int k = 1; k <= half; ++k) {
      Load8(rows.center[k] + x, &after);
      Load8(rows.center[-k] + x, &before);
      even += even_taps[k] * (after + before);
      if (rows.odd) odd += odd_taps[k] * (after - before);
    }
    StoreUpTo(rows.count - x, even, rows.even + x);
    if (rows.odd) StoreUpTo(rows.count - x, odd, rows.odd + x);
  }
}

LIMN_FOR_AVX2 void FilterByAvx2(const HalfKernels& kernels, const FilterRows& rows) {
  Filter(kernels, rows);
}

void FilterBySse2(const HalfKernels& kernels, const FilterRows& rows) { Filter(kernels, rows); }

// `row_at(k)`: row k of the input.
template <typename RowAt>
void FilterAcross(const HalfKernels& kernels, int count, const RowAt& row_at, float* even,
                  float* odd) {
  const int half = static_cast<int>(kernels.even.size()) - 1;
  std::vector<const float*> rows;
  for (int k = -half; k <= half; ++k) rows.push_back(row_at(k));
  const FilterRows filter_rows{rows.data() + half, count, even, odd};
  HasAvx2() ? FilterByAvx2(kernels, filter_rows) : FilterBySse2(kernels, filter_rows);
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
    const int center = last - half;
    if (center < half) continue;
    const size_t out = static_cast<size_t>(center - half) * width;
    FilterAcross(
        kernels, width, [&](int k) { return smooth.Row(center + k); }, field.smooth.data() + out,
        field.dy.data() + out);
    FilterAcross(
        kernels, width, [&](int k) { return derived.Row(center + k); }, field.dx.data() + out,
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

namespace {

// Where a jet is taken: the taps of the kernels along x and y and the values below them.
struct JetPlace {
  const float* kernel_x;
  const float* kernel_y;
  const float* values;  // of the first tap
  int taps;
  int row_size;
  int stride;
  float level;
};

// sums[a][b]: derived a times along y, b times along x, of values less the level.
LIMN_INLINE_KERNEL void JetSums(const JetPlace& place, Float4 (&sums)[4][4]) {
  for (int i = 0; i < place.row_size; i += kBlock) {
    // Down the columns first, a block of them at a time, which stays in registers.
    const float* values = place.values + i;
    Float8 down[4] = {};
    for (int j = 0; j < place.taps; ++j, values += place.stride) {
      Float8 here;
      Load8(values, &here);
      here -= place.level;
      for (int a = 0; a < 4; ++a) down[a] += place.kernel_y[a * place.row_size + j] * here;
    }
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; a + b < 4; ++b) {
        Float8 along;
        Load8(place.kernel_x + b * place.row_size + i, &along);
        along *= down[a];
        Float4 halves[2];
        std::memcpy(halves, &along, sizeof(along));
        sums[a][b] += halves[0] + halves[1];
      }
    }
  }
}

LIMN_FOR_AVX2 void JetSumsByAvx2(const JetPlace& place, Float4 (&sums)[4][4]) {
  JetSums(place, sums);
}

void JetSumsBySse2(const JetPlace& place, Float4 (&sums)[4][4]) { JetSums(place, sums); }

}  // namespace

Jet SubpixelDerivatives::At(double x, double y) const {
  const int column = static_cast<int>(x + 0.5);
  const int row = static_cast<int>(y + 0.5);
  // Truncated, shifted derivative kernels do not sum to zero exactly; subtracting the level of the
  // center pixel keeps a bright plane from leaking into the derivatives.
  const float level = plane_.Row(row)[column];
  const JetPlace place{KernelAt(x - column),
                       KernelAt(y - row),
                       plane_.Row(row - half_size_) + column - half_size_,
                       2 * half_size_ + 1,
                       row_size_,
                       plane_.stride,
                       level};
  Float4 sums[4][4] = {};
  HasAvx2() ? JetSumsByAvx2(place, sums) : JetSumsBySse2(place, sums);
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
