#pragma once

#include <cstdint>

namespace limn {

struct Color {
  uint8_t red = 0;
  uint8_t green = 0;
  uint8_t blue = 0;
};

// A bright, saturated color for a curve; always the same for the same id, and well apart for ids
// that follow each other.
Color ColorOfCurve(int id);

}  // namespace limn
