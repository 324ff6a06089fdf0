#pragma once

namespace limn {

// A unit of lengths. Models themselves have none.
enum class LengthUnit { kNone, kMillimeter, kCentimeter, kMeter, kInch, kFoot };

// 1 for kNone.
inline double Millimeters(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::kNone:
    case LengthUnit::kMillimeter:
      return 1;
    case LengthUnit::kCentimeter:
      return 10;
    case LengthUnit::kMeter:
      return 1000;
    case LengthUnit::kInch:
      return 25.4;
    case LengthUnit::kFoot:
      return 304.8;
  }
  return 1;
}

}  // namespace limn
