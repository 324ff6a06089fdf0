// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/colors.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// One channel of hue (in turns), saturation and value.
uint8_t Channel(double hue, double offset, double saturation, double value) {
  const double place = std::fmod(offset + 6 * hue, 6.0);
  const double ramp = std::clamp(std::min(place, 4 - place), 0.0, 1.0);
  return static_cast<uint8_t>(std::lround(255 * value * (1 - saturation * ramp)));
}

}  // namespace

Color ColorOfCurve(int id) {
  // Steps of the golden ratio spread the hues of any run of ids; brightness takes turns.
  constexpr double kGoldenRatio = 0.6180339887498949;
  const double hue = std::fmod(0.05 + kGoldenRatio * static_cast<uint32_t>(id), 1.0);
  const double saturation = id % 3 == 1 ? 0.65 : 1.0;
  const double value = id % 3 == 2 ? 0.75 : 1.0;
  return {Channel(hue, 5, saturation, value), Channel(hue, 3, saturation, value),
          Channel(hue, 1, saturation, value)};
}

}  // namespace limn
