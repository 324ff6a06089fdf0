// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace limn {

// A number below `count`, at most 2^32, of 32 random bits: the same on all platforms, unlike those
// of std::uniform_int_distribution.
inline size_t RandomIndex(uint32_t random, size_t count) {
  return static_cast<uint64_t>(random) * count >> 32;
}

}  // namespace limn
