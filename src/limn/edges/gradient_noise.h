// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/edges/gaussian_derivatives.h"

namespace limn {

// Standard deviation of one component of the smoothed gradient due to noise, gray levels per px, as
// a function of the gray level: sensors and compression are noisier in bright or in dark parts.
struct NoiseModel {
  // Sampling points, ascending in level; linear between, constant beyond. Empty: no noise.
  std::vector<double> level;
  std::vector<double> noise;

  double At(double gray_level) const;
  // Mean over the sampling points, which represent equal areas.
  double Mean() const;
};

// Measures the noise of an image. Blocks of 32 x 32 px of the plane are divided by their mean gray
// level into up to six groups of about equal size; in each group two measurements bound the noise:
//
// - From above: where the image is flat, the gradient magnitude of Gaussian noise has a Rayleigh
//   distribution, so its quantile q lies at noise * sqrt(-2 ln(1 - q)). A low quantile of a block
//   is insensitive to edges, a low quantile over the blocks to textured blocks; shading and texture
//   everywhere still raise it.
// - From below: the response to a mask that cancels planes and edges (Immerkaer, "Fast noise
//   variance estimation", CVIU 1996) gives the white part of the noise; compression removes it.
//
// The estimate is the first, limited to slightly more than the second. Blocks quieter than
// quantization allows are clipped or synthetic and are ignored. Linear time.
NoiseModel MeasureNoise(const PaddedPlane& plane, const GradientField& gradient, double sigma_px);

// Gradient noise caused by white noise of `pixel_noise` gray levels in the pixels of a plane:
// pixel_noise scale / (sqrt(8 pi) sigma^2), with `scale` pixels of the view, in which the others
// are, per pixel of the plane.
double GradientNoiseFromPixelNoise(double pixel_noise, double sigma_px, double scale);

}  // namespace limn
