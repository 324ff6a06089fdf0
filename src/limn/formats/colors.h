// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace limn {

struct Color {
  uint8_t red = 0;
  uint8_t green = 0;
  uint8_t blue = 0;
};

// A bright, saturated color for a curve: constant for an id, and very different for consecutive
// ids.
Color ColorOfCurve(int id);

}  // namespace limn
