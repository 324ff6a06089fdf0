// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace limn {

// A number below `count`, at most 2^32, of 32 random bits: the same on all platforms, unlike those
// of std::uniform_int_distribution.
inline size_t RandomIndex(uint32_t random, size_t count) {
  return static_cast<uint64_t>(random) * count >> 32;
}

// So many of the values, or all if there are not more, in their order; every choice is equally
// likely. O(values). The same on all platforms, unlike those of std::sample.
template <typename T>
std::vector<T> RandomSample(const std::vector<T>& values, size_t count, std::mt19937* random) {
  std::vector<T> sample;
  for (size_t i = 0; i < values.size() && sample.size() < count; ++i) {
    const size_t index = RandomIndex(static_cast<uint32_t>((*random)()), values.size() - i);
    if (index < count - sample.size()) sample.push_back(values[i]);
  }
  return sample;
}

}  // namespace limn
