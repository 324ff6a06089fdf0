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

// Border that the filters below need at this scale.
int GaussianPadding(double sigma_px);

// Pad a plane of width x height values in row-major order. Both sizes must be positive.
PaddedPlane MakePaddedPlane(const std::vector<float>& values, int width, int height, int pad);

// The Gaussian-smoothed channel and its first derivatives on the pixel grid, row-major, grey levels
// and grey levels per px.
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

// Derivatives at arbitrary positions, by direct convolution with Gaussian kernels shifted by the
// fraction of a pixel: no interpolation, hence no bias towards the grid or the axes. The image is a
// sum of pixels sampled at integers, so an area-sampled step appears with variance sigma^2 + 1/12.
class SubpixelDerivatives {
 public:
  // `plane` must outlive this object and have GaussianPadding(sigma_px).
  SubpixelDerivatives(const PaddedPlane& plane, double sigma_px);

  // (x, y) inside [-0.5, width - 0.5] x [-0.5, height - 0.5]. Cost: (2 ceil(4 sigma + 0.5) + 1)^2
  // x 4.
  Jet At(double x, double y) const;

 private:
  // Values of a Gaussian and its first three derivatives.
  struct Tap {
    float order[4];
  };
  void ShiftedKernel(double fraction, Tap* taps) const;

  const PaddedPlane& plane_;
  double sigma_px_;
  int half_size_;
  std::vector<double> centred_gaussian_;  // taps -half_size_..half_size_
};

}  // namespace limn
