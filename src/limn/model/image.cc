// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/image.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Of a coordinate: the pixels before and behind it, and the weight of the second.
struct Neighbors {
  size_t first;
  size_t second;
  float weight;
};

Neighbors NeighborsOf(double coordinate, int size) {
  const double inside = std::clamp(coordinate, 0.0, static_cast<double>(size - 1));
  const auto first = static_cast<size_t>(inside);
  return {first, std::min(first + 1, static_cast<size_t>(size - 1)),
          static_cast<float>(inside - static_cast<double>(first))};
}

}  // namespace

Eigen::Vector3f ColorAt(const Image& image, const Eigen::Vector2d& px) {
  const Neighbors x = NeighborsOf(px.x(), image.width);
  const Neighbors y = NeighborsOf(px.y(), image.height);
  const auto in_row = [&](size_t row, int channel) {
    const float* values = image.data.data() + row * image.width * image.channels + channel;
    const float first = values[x.first * image.channels];
    return first + x.weight * (values[x.second * image.channels] - first);
  };
  Eigen::Vector3f color;
  for (int c = 0; c < 3; ++c) {
    const int channel = std::min(c, image.channels - 1);
    const float above = in_row(y.first, channel);
    color[c] = above + y.weight * (in_row(y.second, channel) - above);
  }
  return color;
}

Image AtViewSize(const Image& image) {
  Image enlarged{image.ViewWidth(), image.ViewHeight(), image.channels, {}, {}};
  enlarged.data.reserve(static_cast<size_t>(enlarged.width) * enlarged.height * image.channels);
  for (int y = 0; y < enlarged.height; ++y) {
    for (int x = 0; x < enlarged.width; ++x) {
      const Eigen::Vector3f color = ColorAt(image, image.FromView({x, y}));
      for (int c = 0; c < image.channels; ++c) enlarged.data.push_back(color[c]);
    }
  }
  return enlarged;
}

}  // namespace limn
