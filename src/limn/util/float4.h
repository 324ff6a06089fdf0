// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>

// Of functions that are also called in code for other instruction sets (float8.h).
#define LIMN_INLINE_KERNEL inline __attribute__((always_inline))

namespace limn {

// Four floats as a vector type of GCC and Clang: SSE2 on every x86-64, so that results do not
// depend on the machine. Operators work elementwise, also with a float on one side, as does `a < b
// ? x : y`.
using Float4 = float __attribute__((vector_size(16)));
// Result of a comparison: all bits of an element are set where it holds.
using Mask4 = int32_t __attribute__((vector_size(16)));

// The address need not be aligned.
inline Float4 Load4(const float* from) {
  Float4 values;
  std::memcpy(&values, from, sizeof(values));
  return values;
}
inline void Store4(Float4 values, float* to) { std::memcpy(to, &values, sizeof(values)); }

inline Float4 Splat4(float value) { return Float4{value, value, value, value}; }
inline Float4 Min4(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 Max4(Float4 a, Float4 b) { return a > b ? a : b; }
inline Float4 Abs4(Float4 a) { return Max4(a, -a); }
// Whether any element of a comparison holds.
inline bool Any4(Mask4 mask) {
  uint64_t halves[2];
  std::memcpy(halves, &mask, sizeof(halves));
  return (halves[0] | halves[1]) != 0;
}
// A bit per element of a comparison, the first one lowest.
LIMN_INLINE_KERNEL unsigned Bits4(Mask4 mask) {
#if defined(__SSE2__)
  return static_cast<unsigned>(__builtin_ia32_movmskps(reinterpret_cast<Float4>(mask)));
#else
  const Mask4 bits = mask & Mask4{1, 2, 4, 8};
  return static_cast<unsigned>((bits[0] | bits[1]) | (bits[2] | bits[3]));
#endif
}
inline float Sum4(Float4 a) { return (a[0] + a[1]) + (a[2] + a[3]); }

}  // namespace limn
