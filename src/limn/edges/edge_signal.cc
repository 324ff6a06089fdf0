// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/edge_signal.h"

#include <utility>

#include "limn/edges/grid_maxima.h"
#include "limn/edges/lab_channels.h"

namespace limn {
namespace {

// Rec. 601 luma.
ChannelValues Luminance(const Image& image) {
  const size_t size = static_cast<size_t>(image.width) * image.height;
  ChannelValues values(size);
  for (size_t i = 0; i < size; ++i) {
    const float* rgb = image.data.data() + 3 * i;
    values[i] = 0.299f * rgb[0] + 0.587f * rgb[1] + 0.114f * rgb[2];
  }
  return values;
}

ChannelGradients GradientsAt(const std::vector<GradientField>& fields, size_t pixel) {
  ChannelGradients gradients;
  for (size_t k = 0; k < kMaxChannels; ++k) {
    gradients[k] = {fields[k].dx[pixel], fields[k].dy[pixel]};
  }
  return gradients;
}

// The joint gradient on the grid, with the `smooth` of the first channel.
GradientField JointField(const std::vector<GradientField>& fields) {
  GradientField joint = fields[0];
  for (size_t i = 0; i < joint.dx.size(); ++i) {
    const JointGradient at = JoinGradients(GradientsAt(fields, i));
    joint.dx[i] = static_cast<float>(at.magnitude * at.normal.x());
    joint.dy[i] = static_cast<float>(at.magnitude * at.normal.y());
  }
  return joint;
}

}  // namespace

ChannelShares EdgeSignal::SharesAt(size_t pixel) const {
  if (channel_gradients.empty()) return {1, 0, 0};
  const ChannelGradients gradients = GradientsAt(channel_gradients, pixel);
  return SharesOf(gradients, JoinGradients(gradients));
}

EdgeSignal PrepareSignal(const std::vector<ChannelValues>& channels, const Image& image,
                         double sigma_px) {
  EdgeSignal signal;
  signal.scale = image.scale;
  signal.sigma_px = sigma_px;
  const double scale = image.scale.mean();
  signal.kernels = std::make_shared<const GaussianKernels>(sigma_px, scale);
  const int padding = GaussianPadding(sigma_px, scale);
  for (const ChannelValues& values : channels) {
    signal.planes.push_back(MakePaddedPlane(values, image.width, image.height, padding));
    GradientField field = SmoothedGradient(signal.planes.back(), *signal.kernels, image.ViewWidth(),
                                           image.ViewHeight());
    // Noise depends on the brightness.
    if (!signal.channel_gradients.empty()) field.smooth = signal.channel_gradients[0].smooth;
    signal.noise.push_back(MeasureNoise(signal.planes.back(), field, sigma_px));
    signal.channel_gradients.push_back(std::move(field));
  }
  if (channels.size() == 1) {
    signal.gradient = std::move(signal.channel_gradients[0]);
    signal.channel_gradients.clear();
  } else {
    signal.gradient = JointField(signal.channel_gradients);
    for (GradientField& field : signal.channel_gradients) field.smooth = {};
  }
  signal.magnitude = GradientMagnitude(signal.gradient);
  return signal;
}

ChannelValues ExtractChannel(const Image& image, int channel) {
  const size_t size = static_cast<size_t>(image.width) * image.height;
  ChannelValues values(size);
  for (size_t i = 0; i < size; ++i) values[i] = image.data[i * image.channels + channel];
  return values;
}

std::vector<ChannelValues> SearchedChannels(const Image& image, EdgeChannel channel) {
  if (image.channels == 1) return {image.data};
  if (channel == EdgeChannel::kGreen) return {ExtractChannel(image, 1)};
  if (channel == EdgeChannel::kLuminance) return {Luminance(image)};
  auto lab = LabChannels(image);
  return {std::move(lab[0]), std::move(lab[1]), std::move(lab[2])};
}

}  // namespace limn
