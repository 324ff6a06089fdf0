// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/lab_channels.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr float kGrayLevelsPerLab = 2.55f;

// Linear light, 0 to 1, of the gray levels; one more than there are, to interpolate.
std::array<float, 257> LinearLight() {
  std::array<float, 257> linear;
  for (size_t i = 0; i < linear.size(); ++i) {
    const double v = static_cast<double>(i) / 255;
    linear[i] = static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
  }
  return linear;
}

// The cube root, with a straight line below 1/116.
float LabCurve(float t) {
  constexpr float kDelta = 6.f / 29;
  return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.f / 29;
}

}  // namespace

std::array<std::vector<float>, kMaxChannels> LabChannels(const Image& image) {
  const std::array<float, 257> table = LinearLight();
  const auto linear = [&table](float level) {
    const float clamped = std::clamp(level, 0.f, 255.f);
    const auto i = static_cast<size_t>(clamped);
    return table[i] + (clamped - static_cast<float>(i)) * (table[i + 1] - table[i]);
  };
  const size_t size = static_cast<size_t>(image.width) * image.height;
  std::array<std::vector<float>, kMaxChannels> lab;
  for (std::vector<float>& channel : lab) channel.resize(size);
  for (size_t i = 0; i < size; ++i) {
    const float r = linear(image.data[3 * i]);
    const float g = linear(image.data[3 * i + 1]);
    const float b = linear(image.data[3 * i + 2]);
    // Over those of white.
    const float x = LabCurve(0.433953f * r + 0.376219f * g + 0.189828f * b);
    const float y = LabCurve(0.212671f * r + 0.715160f * g + 0.072169f * b);
    const float z = LabCurve(0.017758f * r + 0.109477f * g + 0.872765f * b);
    lab[0][i] = kGrayLevelsPerLab * (116 * y - 16);
    lab[1][i] = kGrayLevelsPerLab * 500 * (x - y);
    lab[2][i] = kGrayLevelsPerLab * 200 * (y - z);
  }
  return lab;
}

}  // namespace limn
