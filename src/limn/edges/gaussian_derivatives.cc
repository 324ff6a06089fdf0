// SPDX-License-Identifier: BSD-3-Clause
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

// Narrower Gaussians are those of interpolated pixels.
constexpr double kNarrowPx = 1;

int HalfSize(double sigma_px) {
  return static_cast<int>(std::ceil(4 * sigma_px + (sigma_px < kNarrowPx ? 1 : 0.5)));
}

double Gaussian(double x, double sigma) {
  return std::exp(-0.5 * x * x / (sigma * sigma)) / (std::sqrt(2 * std::numbers::pi) * sigma);
}

// Keys' interpolation kernel, 0 beyond 2.
double Cubic(double x) {
  x = std::abs(x);
  if (x < 1) return (1.5 * x - 2.5) * x * x + 1;
  return x < 2 ? ((-0.5 * x + 2.5) * x - 4) * x + 2 : 0;
}

// The Gaussian and its derivatives at u px from the place, correlated, not convolved.
Eigen::Array4d GaussianAt(double u, double sigma_px) {
  const double inverse_variance = 1 / (sigma_px * sigma_px);
  const double v = u * inverse_variance;
  return Gaussian(u, sigma_px) *
         Eigen::Array4d(1, v, v * v - inverse_variance, v * (v * v - 3 * inverse_variance));
}

// The same of interpolated pixels.
Eigen::Array4d KernelAt(double u, double sigma_px) {
  if (sigma_px >= kNarrowPx) return GaussianAt(u, sigma_px);
  constexpr int kStepsPerPx = 8;
  Eigen::Array4d sum = Eigen::Array4d::Zero();
  for (int i = -2 * kStepsPerPx + 1; i < 2 * kStepsPerPx; ++i) {
    const double x = static_cast<double>(i) / kStepsPerPx;
    sum += Cubic(x) / kStepsPerPx * GaussianAt(u - x, sigma_px);
  }
  return sum;
}

// Where pixels of the view are in the plane, along x or y: the nearest pixels and the kernels.
struct GridTaps {
  std::vector<int> pixel;
  std::vector<const float*> kernel;
};

GridTaps TapsOf(const GaussianKernels& kernels, int count, int count_in_view) {
  const double scale = static_cast<double>(count_in_view) / count;
  GridTaps taps;
  for (int i = 0; i < count_in_view; ++i) {
    const double place = (i + 0.5) / scale - 0.5;
    taps.pixel.push_back(static_cast<int>(std::lround(place)));
    taps.kernel.push_back(kernels.At(place - taps.pixel.back()));
  }
  return taps;
}

LIMN_INLINE_KERNEL void StoreUpTo(int count, const Float8& values, float* to) {
  if (count >= kBlock) {
    Store8(values, to);
  } else {
    std::memcpy(to, &values, sizeof(float) * count);
  }
}

// A row of the plane filtered along x. Its first pixel is row[0]; it is read half_size before and
// row_size - half_size beyond every pixel.
LIMN_INLINE_KERNEL void FilterAlong(const GridTaps& taps, const GaussianKernels& kernels,
                                    const float* row, float* even, float* odd) {
  const int row_size = kernels.row_size();
  const float* first = row - kernels.half_size();
  for (size_t x = 0; x < taps.pixel.size(); ++x) {
    Float8 sums[2] = {};
    for (int k = 0; k < row_size; k += kBlock) {
      Float8 here, tap;
      Load8(first + taps.pixel[x] + k, &here);
      for (int a = 0; a < 2; ++a) {
        Load8(taps.kernel[x] + a * row_size + k, &tap);
        sums[a] += tap * here;
      }
    }
    Float4 halves[4];
    std::memcpy(halves, sums, sizeof(sums));
    even[x] = Sum4(halves[0] + halves[1]);
    odd[x] = Sum4(halves[2] + halves[3]);
  }
}

LIMN_FOR_AVX2 void FilterAlongByAvx2(const GridTaps& taps, const GaussianKernels& kernels,
                                     const float* row, float* even, float* odd) {
  FilterAlong(taps, kernels, row, even, odd);
}

void FilterAlongBySse2(const GridTaps& taps, const GaussianKernels& kernels, const float* row,
                       float* even, float* odd) {
  FilterAlong(taps, kernels, row, even, odd);
}

// What a filter across rows reads and writes. Rows are read up to kBlock - 1 values beyond the
// count.
struct FilterRows {
  std::vector<const float*> rows;
  int count;  // values of a row
  float* to;
};

LIMN_INLINE_KERNEL void FilterAcross(const float* taps, const FilterRows& filter) {
  const int num_rows = static_cast<int>(filter.rows.size());
  for (int x = 0; x < filter.count; x += kBlock) {
    Float8 sum = {};
    for (int k = 0; k < num_rows; ++k) {
      Float8 here;
      Load8(filter.rows[k] + x, &here);
      sum += taps[k] * here;
    }
    StoreUpTo(filter.count - x, sum, filter.to + x);
  }
}

LIMN_FOR_AVX2 void FilterAcrossByAvx2(const float* taps, const FilterRows& filter) {
  FilterAcross(taps, filter);
}

void FilterAcrossBySse2(const float* taps, const FilterRows& filter) { FilterAcross(taps, filter); }

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

int GaussianPadding(double sigma_px, double scale) { return HalfSize(sigma_px / scale) + kBlock; }

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

GaussianKernels::GaussianKernels(double sigma_px, double scale)
    : half_size_(HalfSize(sigma_px / scale)) {
  const int taps = 2 * half_size_ + 1;
  row_size_ = (taps + kBlock - 1) / kBlock * kBlock;
  kernels_.assign(static_cast<size_t>(kNodesPerPx + 1) * 4 * row_size_, 0.f);
  for (int node = 0; node <= kNodesPerPx; ++node) {
    const double fraction = static_cast<double>(node) / kNodesPerPx - 0.5;
    float* kernel = kernels_.data() + static_cast<size_t>(node) * 4 * row_size_;
    std::vector<Eigen::Array4d> values;
    Eigen::Array4d sums = Eigen::Array4d::Zero();
    for (int i = 0; i < taps; ++i) {
      values.push_back(KernelAt(i - half_size_ - fraction, sigma_px / scale));
      sums += values.back();
    }
    // What truncation takes from a constant image is given back.
    for (int i = 0; i < taps; ++i) {
      const double share = values[i][0] / sums[0];
      kernel[i] = static_cast<float>(share);
      for (int a = 1; a < 4; ++a) {
        const double derivative = (values[i][a] - share * sums[a]) * std::pow(scale, -a);
        kernel[a * row_size_ + i] = static_cast<float>(derivative);
      }
    }
  }
}

const float* GaussianKernels::At(double fraction) const {
  const int node = static_cast<int>((fraction + 0.5) * kNodesPerPx + 0.5);
  return kernels_.data() + static_cast<size_t>(node) * 4 * row_size_;
}

GradientField SmoothedGradient(const PaddedPlane& plane, const GaussianKernels& kernels, int width,
                               int height) {
  const int half = kernels.half_size();
  const int num_rows = 2 * half + 1;
  const GridTaps columns = TapsOf(kernels, plane.width, width);
  const GridTaps rows = TapsOf(kernels, plane.height, height);
  const size_t size = static_cast<size_t>(width) * height;
  GradientField field{width, height, std::vector<float>(size), std::vector<float>(size),
                      std::vector<float>(size)};
  RowRing smooth(num_rows, width);
  RowRing derived(num_rows, width);
  const auto filter_across = [&](RowRing* ring, int first, const float* taps, float* to) {
    FilterRows filter{{}, width, to};
    for (int k = 0; k < num_rows; ++k) filter.rows.push_back(ring->Row(first + k));
    HasAvx2() ? FilterAcrossByAvx2(taps, filter) : FilterAcrossBySse2(taps, filter);
  };
  int next = 0;  // rows of the plane that are in the rings, counted from -half
  for (int y = 0; y < height; ++y) {
    for (; next <= rows.pixel[y] + 2 * half; ++next) {
      const auto filter = HasAvx2() ? FilterAlongByAvx2 : FilterAlongBySse2;
      filter(columns, kernels, plane.Row(next - half), smooth.Row(next), derived.Row(next));
    }
    const size_t out = static_cast<size_t>(y) * width;
    const float* taps = rows.kernel[y];
    filter_across(&smooth, rows.pixel[y], taps, field.smooth.data() + out);
    filter_across(&smooth, rows.pixel[y], taps + kernels.row_size(), field.dy.data() + out);
    filter_across(&derived, rows.pixel[y], taps, field.dx.data() + out);
  }
  return field;
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

Eigen::Vector2d SubpixelDerivatives::NearestNode(const Eigen::Vector2d& px) const {
  constexpr double kNodesPerPx = GaussianKernels::kNodesPerPx;
  // Not below 0, so that casts round down.
  const Eigen::Array2d from_minus_one = (px.array() + 0.5) / scale_ + 0.5;
  const Eigen::Array2d node =
      (from_minus_one * kNodesPerPx + 0.5).cast<int>().cast<double>() / kNodesPerPx;
  return ((node - 0.5) * scale_ - 0.5).matrix();
}

Jet SubpixelDerivatives::At(const Eigen::Vector2d& node) const {
  const Eigen::Array2d place = (node.array() + 0.5) / scale_ - 0.5;
  const int column = static_cast<int>(place.x() + 0.5);
  const int row = static_cast<int>(place.y() + 0.5);
  const int half = kernels_->half_size();
  // Truncated, shifted derivative kernels do not sum to zero exactly; subtracting the level of the
  // center pixel keeps a bright plane from leaking into the derivatives.
  const float level = plane_->Row(row)[column];
  const JetPlace taps{kernels_->At(place.x() - column),
                      kernels_->At(place.y() - row),
                      plane_->Row(row - half) + column - half,
                      2 * half + 1,
                      kernels_->row_size(),
                      plane_->stride,
                      level};
  Float4 sums[4][4] = {};
  HasAvx2() ? JetSumsByAvx2(taps, sums) : JetSumsBySse2(taps, sums);
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
