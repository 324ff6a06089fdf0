// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace limn {

// A unit of lengths. Models themselves have none.
enum class LengthUnit { kNone, kMillimeter, kCentimeter, kMeter, kInch, kFoot };

// "mm", "cm", "m", "in", "ft"; empty for kNone.
inline const char* UnitName(LengthUnit unit) {
  constexpr const char* kNames[] = {"", "mm", "cm", "m", "in", "ft"};
  return kNames[static_cast<int>(unit)];
}

// kNone for another name.
inline LengthUnit UnitOfName(std::string_view name) {
  for (const LengthUnit unit : {LengthUnit::kMillimeter, LengthUnit::kCentimeter,
                                LengthUnit::kMeter, LengthUnit::kInch, LengthUnit::kFoot}) {
    if (name == UnitName(unit)) return unit;
  }
  return LengthUnit::kNone;
}

// 1 for kNone.
inline double Millimeters(LengthUnit unit) {
  constexpr double kMillimeters[] = {1, 1, 10, 1000, 25.4, 304.8};
  return kMillimeters[static_cast<int>(unit)];
}

}  // namespace limn
