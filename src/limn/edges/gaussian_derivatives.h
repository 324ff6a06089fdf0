// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

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

// Border required by the kernels below, px of the plane.
int GaussianPadding(double sigma_px, double scale);

// Pads a plane of width x height values in row-major order. Both sizes must be positive.
PaddedPlane MakePaddedPlane(const std::vector<float>& values, int width, int height, int pad);

// The Gaussian-smoothed channel and its first derivatives at the pixels of the view, row-major,
// gray levels and gray levels per px.
struct GradientField {
  int width = 0;
  int height = 0;
  std::vector<float> smooth;
  std::vector<float> dx;
  std::vector<float> dy;
};

// All partial derivatives of order 0 to 3 of the Gaussian-smoothed channel at one point.
struct Jet {
  double value = 0;
  double x = 0, y = 0;
  double xx = 0, xy = 0, yy = 0;
  double xxx = 0, xxy = 0, xyy = 0, yyy = 0;
};

// The Gaussian and its first three derivatives. A Gaussian of less than 1 px of the plane is
// convolved with Keys' cubic interpolation of the pixels ("Cubic convolution interpolation", 1981):
// its bare samples would pull edges to the grid of pixels.
class GaussianKernels {
 public:
  static constexpr int kNodesPerPx = 256;

  // Sigma is in pixels of the view, of which there are `scale` per pixel of the plane; derivatives
  // are per pixel of the view.
  GaussianKernels(double sigma_px, double scale);

  // Taps are at -half_size() to half_size() from the pixel nearest to the place.
  int half_size() const { return half_size_; }
  // Taps of a derivative, with zeros beyond 2 half_size() + 1.
  int row_size() const { return row_size_; }

  // For a place that lies this fraction of a pixel, -0.5 to 0.5, behind its nearest pixel: 4 x
  // row_size() taps.
  const float* At(double fraction) const;

 private:
  int half_size_;
  int row_size_;
  std::vector<float> kernels_;  // by node, from -0.5 to 0.5
};

// Of a plane that is width x height pixels of the view. Separable filters: linear in these times
// the size of the kernels.
GradientField SmoothedGradient(const PaddedPlane& plane, const GaussianKernels& kernels, int width,
                               int height);

// Derivatives between the pixels, by direct convolution with kernels shifted by the fraction of a
// pixel. They are evaluated at nodes, kNodesPerPx per pixel of the plane, with precomputed kernels.
// Pixels are area samples, so a step appears blurred with variance sigma^2 + 1/12.
class SubpixelDerivatives {
 public:
  // Both must outlive this object; the plane has GaussianPadding. `scale`: pixels of the view per
  // pixel of the plane.
  SubpixelDerivatives(const PaddedPlane& plane, const GaussianKernels& kernels,
                      const Eigen::Array2d& scale)
      : plane_(&plane), kernels_(&kernels), scale_(scale) {}

  // The node nearest to a pixel of the view inside the image or less than half a pixel of the plane
  // beside it.
  Eigen::Vector2d NearestNode(const Eigen::Vector2d& px) const;

  // At a node. Cost: 4 (2 half_size + 1)^2 of the kernels.
  Jet At(const Eigen::Vector2d& node) const;

 private:
  const PaddedPlane* plane_;
  const GaussianKernels* kernels_;
  Eigen::Array2d scale_;
};

}  // namespace limn
