#pragma once

#include <vector>

namespace limn {

// One channel with a replicated border of `pad` pixels on all sides, row-major.
struct PaddedPlane {
  int width = 0;
  int height = 0;
  int pad = 0;
  int stride = 0;
  std::vector<float> values;

  // Row y in [-pad, height + pad); valid from index -pad to width + pad - 1.
  const float* Row(int y) const { return values.data() + (y + pad) * stride + pad; }
  float* Row(int y) { return values.data() + (y + pad) * stride + pad; }
};

// Border required by the filters below at this scale.
int GaussianPadding(double sigma_px);

// Pads a plane of width x height values in row-major order. Both sizes must be positive.
PaddedPlane MakePaddedPlane(const std::vector<float>& values, int width, int height, int pad);

// The Gaussian-smoothed channel and its first derivatives on the pixel grid, row-major, gray levels
// and gray levels per px.
struct GradientField {
  int width = 0;
  int height = 0;
  std::vector<float> smooth;
  std::vector<float> dx;
  std::vector<float> dy;
};

// Separable filters with half-size ceil(4 sigma). Linear in pixels times kernel size.
GradientField SmoothedGradient(const PaddedPlane& plane, double sigma_px);

// All partial derivatives of order 0 to 3 of the Gaussian-smoothed channel at one point.
struct Jet {
  double value = 0;
  double x = 0, y = 0;
  double xx = 0, xy = 0, yy = 0;
  double xxx = 0, xxy = 0, xyy = 0, yyy = 0;
};

// Derivatives between the pixels, by direct convolution with Gaussian kernels shifted by the
// fraction of a pixel: no interpolation, hence no bias towards the grid or the axes. They are
// evaluated at nodes, kNodesPerPx per pixel, with precomputed kernels. Pixels are area samples, so
// a step appears blurred with variance sigma^2 + 1/12.
class SubpixelDerivatives {
 public:
  static constexpr int kNodesPerPx = 256;

  // `plane` must outlive this object and have GaussianPadding(sigma_px).
  SubpixelDerivatives(const PaddedPlane& plane, double sigma_px);

  // The node nearest to a coordinate >= -1.
  static double NearestNode(double coordinate) {
    return static_cast<double>(static_cast<int>((coordinate + 1) * kNodesPerPx + 0.5)) /
               kNodesPerPx -
           1;
  }

  // (x, y): a node inside [-0.5, width - 0.5] x [-0.5, height - 0.5]. Cost: (2 ceil(4 sigma + 0.5)
  // + 1)^2 x 4.
  Jet At(double x, double y) const;

 private:
  // The Gaussian and its first three derivatives, shifted by a fraction of a pixel: 4 x row_size_
  // taps, of which those beyond 2 half_size_ + 1 are 0.
  const float* KernelAt(double fraction) const;

  const PaddedPlane& plane_;
  int half_size_;
  int row_size_;
  std::vector<float> kernels_;  // by node, from -0.5 to 0.5
};

}  // namespace limn
