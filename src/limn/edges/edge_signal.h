// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "limn/edges/edge_channel.h"
#include "limn/edges/gaussian_derivatives.h"
#include "limn/edges/gradient_noise.h"
#include "limn/edges/joint_gradient.h"
#include "limn/model/image.h"

namespace limn {

// A channel on the pixels of an image, row-major.
using ChannelValues = std::vector<float>;

// One channel, or L, a and b jointly, prepared for detection at one scale.
struct EdgeSignal {
  // Pixels of the view per pixel of the image, in both directions.
  Eigen::Vector2d scale = Eigen::Vector2d::Ones();
  double sigma_px = 0;  // of the view
  std::shared_ptr<const GaussianKernels> kernels;
  std::vector<PaddedPlane> planes;  // of every channel
  // The joint gradient, directed as that of the first channel, or see JointGradient. `smooth` is
  // the first channel.
  GradientField gradient;
  std::vector<float> magnitude;
  std::vector<NoiseModel> noise;  // of every channel, by the level of the first one

  // The shares that the channels have of the gradient at a pixel.
  ChannelShares SharesAt(size_t pixel) const;

  std::vector<GradientField> channel_gradients;  // without `smooth`; empty if there is one channel
};

// Of one or three channels of an image. Linear time.
EdgeSignal PrepareSignal(const std::vector<ChannelValues>& channels, const Image& image,
                         double sigma_px);

// A channel of an image.
ChannelValues ExtractChannel(const Image& image, int channel);

// The channels to search jointly: green, luminance (Rec. 601) or Lab, all the same for an image of
// one channel.
std::vector<ChannelValues> SearchedChannels(const Image& image, EdgeChannel channel);

}  // namespace limn
