#pragma once

#include <bit>
#include <cstring>
#include <ostream>

namespace limn {

// Appends values in little-endian byte order.
template <typename T>
void PutLittleEndian(std::ostream& out, T value) {
  static_assert(std::endian::native == std::endian::little, "byte swapping is not written yet");
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.write(bytes, sizeof(T));
}

}  // namespace limn
