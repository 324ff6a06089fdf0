// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "limn/edges/gaussian_derivatives.h"
#include "limn/edges/gradient_noise.h"
#include "limn/edges/joint_gradient.h"
#include "limn/model/edgel.h"

namespace limn {

// Parameters of the refinement of a candidate.
struct RefinementContext {
  // Lengths are in pixels of the view, of which there are so many per pixel of the image.
  double scale = 1;
  double sigma_px = 1.5;
  // Of every channel, by the level of the first one.
  std::vector<NoiseModel> noise;
  // Weakest edge accepted: the larger of noise_factor times the noise at its gray level and
  // min_strength, gray levels per px.
  double noise_factor = 0;
  double min_strength = 0;

  double ThresholdFor(double gradient_noise) const {
    return std::max(noise_factor * gradient_noise, min_strength);
  }
  // Noise of the gradient across an edge that the channels have these shares of.
  double NoiseOf(double level, const ChannelShares& shares) const;
};

// An edgel, its strength in multiples of the threshold that applied to it, >= 1, and the blur of
// the edge: standard deviation of the Gaussian that a step is convolved with, px of the view.
struct RefinedEdgel {
  Edgel edgel;
  double significance = 1;
  double blur_px = 0;
};

// The maximum of the gradient magnitude along the gradient near the pixel (x, y), or nothing if
// there is none within 0.7 px (larger coordinate) or it is weaker than the threshold. The tangent
// is directed so that the channel rises along Edgel::Normal(). Of one channel or of three jointly:
// see AlongJointGradient.
std::optional<RefinedEdgel> RefineEdgel(std::span<const SubpixelDerivatives> derivatives, int x,
                                        int y, const RefinementContext& context);

}  // namespace limn
