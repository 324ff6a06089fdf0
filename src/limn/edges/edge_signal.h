#pragma once

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
  double sigma_px = 0;
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

// Of one or three channels. Linear time.
EdgeSignal PrepareSignal(const std::vector<ChannelValues>& channels, int width, int height,
                         double sigma_px);

// A channel of an image.
ChannelValues ExtractChannel(const Image& image, int channel);

// The channels to search jointly: green, luminance (Rec. 601) or Lab, all the same for an image of
// one channel.
std::vector<ChannelValues> SearchedChannels(const Image& image, EdgeChannel channel);

}  // namespace limn
