// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

#include "limn/util/parallel.h"
#include "limn/util/serialize.h"

namespace limn {

namespace internal {

// Runs make(i) for i in [0, count). With a team, each i runs on one rank, and put(i) and get(i)
// copy its result to the others.
void ShareOut(const RunContext& context, const char* stage, size_t count,
              const std::function<void(size_t)>& make,
              const std::function<void(size_t, ByteWriter*)>& put,
              const std::function<void(size_t, ByteReader*)>& get);

}  // namespace internal

// The results of make(i) for i in [0, count), computed by all threads and, if the context has a
// team, by all its ranks, each of which gets all results. They are the same for any number of
// threads and ranks if calls of make are independent. Results must be serializable (serialize.h),
// but are serialized only with a team. See ParallelFor for exceptions and `stage`.
template <class Make>
auto MapItems(const RunContext& context, const char* stage, size_t count, const Make& make) {
  using Result = std::invoke_result_t<const Make&, size_t>;
  static_assert(!std::is_same_v<Result, bool>,
                "elements of a vector<bool> share bytes: return uint8_t");
  std::vector<Result> results(count);
  internal::ShareOut(
      context, stage, count, [&](size_t i) { results[i] = make(i); },
      [&](size_t i, ByteWriter* out) { Serialize(results[i], out); },
      [&](size_t i, ByteReader* in) { Deserialize(in, &results[i]); });
  return results;
}

// MapItems for results that do not all fit in memory: each is passed to take(i, result), in the
// order of i, before the next block of items is computed.
template <class Make, class Take>
void MapItemsInBlocks(const RunContext& context, const char* stage, size_t count, const Make& make,
                      const Take& take) {
  constexpr size_t kBlock = 4096;
  for (size_t begin = 0; begin < count; begin += kBlock) {
    auto results = MapItems(PartOf(context, begin, count), stage, std::min(kBlock, count - begin),
                            [&](size_t i) { return make(begin + i); });
    for (size_t i = 0; i < results.size(); ++i) take(begin + i, std::move(results[i]));
  }
}

}  // namespace limn
