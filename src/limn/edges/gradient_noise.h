#pragma once

#include "limn/edges/gaussian_derivatives.h"

namespace limn {

// Standard deviation of one component of the smoothed gradient due to noise, grey levels per px.
//
// Where the image is flat, the gradient magnitude of Gaussian noise has a Rayleigh distribution, so
// its quantile q lies at noise * sqrt(-2 ln(1 - q)). A low quantile is taken in each block of 32 x
// 32 px (edges fill only the upper part of a block's distribution), and a low quantile over the
// blocks (texture and shading only raise a block's value). Blocks quieter than quantisation allows
// are clipped or synthetic and tell nothing; 0 if no other block exists. Linear time.
double EstimateGradientNoise(const GradientField& gradient, double sigma_px);

// Gradient noise that white noise of `pixel_noise` grey levels causes: pixel_noise / (sqrt(8 pi)
// s^2).
double GradientNoiseFromPixelNoise(double pixel_noise, double sigma_px);

}  // namespace limn
