// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <istream>

namespace limn::colmap_ext {

// The next bytes of a stream as a number; negative at its end. At most seven.
inline int64_t ReadBigEndian(std::istream& in, int num_bytes) {
  int64_t value = 0;
  for (int i = 0; i < num_bytes; ++i) {
    const int byte = in.get();
    if (byte < 0) return -1;
    value = value << 8 | byte;
  }
  return value;
}

inline int64_t ReadLittleEndian(std::istream& in, int num_bytes) {
  int64_t value = 0;
  for (int i = 0; i < num_bytes; ++i) {
    const int byte = in.get();
    if (byte < 0) return -1;
    value |= int64_t{byte} << (8 * i);
  }
  return value;
}

}  // namespace limn::colmap_ext
