// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>

#include "limn/util/float4.h"

namespace limn {

// Eight floats as a vector type, like Float4 (float4.h): one register with AVX2, two with SSE2.
// Both round alike, since nothing is fused or reordered, so that results do not depend on the
// machine.
//
// A kernel is written once, as a function that is always inlined and calls nothing else, and
// compiled twice:
//
//   LIMN_INLINE_KERNEL void Scale(...) { ... }
//   LIMN_FOR_AVX2 void ScaleByAvx2(...) { Scale(...); }
//   void ScaleBySse2(...) { Scale(...); }
//
// and HasAvx2() chooses. Pass such values by reference: passing by value depends on the instruction
// set.
//
// Without the attribute GCC aligns them to 16 bytes without AVX and to 32 with it.
using Float8 = float __attribute__((vector_size(32), aligned(32)));
// Result of a comparison: all bits of an element are set where it holds.
using Mask8 = int32_t __attribute__((vector_size(32), aligned(32)));

#if defined(__x86_64__)
#define LIMN_FOR_AVX2 __attribute__((target("avx2")))
inline bool HasAvx2() { return __builtin_cpu_supports("avx2") != 0; }
#else
#define LIMN_FOR_AVX2
inline bool HasAvx2() { return false; }
#endif

// The address need not be aligned.
LIMN_INLINE_KERNEL void Load8(const float* from, Float8* values) {
  std::memcpy(values, from, sizeof(*values));
}
LIMN_INLINE_KERNEL void Store8(const Float8& values, float* to) {
  std::memcpy(to, &values, sizeof(values));
}

// Whether any element of a comparison holds.
LIMN_INLINE_KERNEL bool Any8(const Mask8& mask) {
  uint64_t quarters[4];
  std::memcpy(quarters, &mask, sizeof(quarters));
  return ((quarters[0] | quarters[1]) | (quarters[2] | quarters[3])) != 0;
}

// A bit per element of a comparison, the first one lowest.
LIMN_INLINE_KERNEL unsigned Bits8(const Mask8& mask) {
  Mask4 halves[2];
  std::memcpy(halves, &mask, sizeof(halves));
  return Bits4(halves[0]) | Bits4(halves[1]) << 4;
}

}  // namespace limn
