#pragma once

namespace limn {

// What one unit of a file's coordinates is. Models have no unit of their own.
enum class LengthUnit { kNone, kMillimetre, kCentimetre, kMetre, kInch, kFoot };

// 1 for kNone.
inline double Millimetres(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::kNone:
    case LengthUnit::kMillimetre:
      return 1;
    case LengthUnit::kCentimetre:
      return 10;
    case LengthUnit::kMetre:
      return 1000;
    case LengthUnit::kInch:
      return 25.4;
    case LengthUnit::kFoot:
      return 304.8;
  }
  return 1;
}

}  // namespace limn
