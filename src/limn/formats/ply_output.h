// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstring>
#include <ostream>
#include <string>

#include "limn/formats/colors.h"
#include "limn/util/length_unit.h"

namespace limn {

// Appends values in little-endian byte order.
template <typename T>
void PutLittleEndian(std::ostream& out, T value) {
  static_assert(std::endian::native == std::endian::little, "byte swapping is not written yet");
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.write(bytes, sizeof(T));
}

// A line of the header; empty for kNone.
inline std::string UnitComment(LengthUnit unit) {
  return unit == LengthUnit::kNone ? "" : std::string("comment unit: ") + UnitName(unit) + '\n';
}

inline void PutColor(std::ostream& out, const Color& color) {
  PutLittleEndian(out, color.red);
  PutLittleEndian(out, color.green);
  PutLittleEndian(out, color.blue);
}

}  // namespace limn
