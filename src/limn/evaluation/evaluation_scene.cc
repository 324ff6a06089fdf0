// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/evaluation_scene.h"

#include <algorithm>

namespace limn {
namespace {

constexpr size_t kChunk = 512;

}  // namespace

void ForEachSample(const RunContext& context, int count, const std::function<void(int)>& body) {
  const size_t num_chunks = (count + kChunk - 1) / kChunk;
  ParallelFor(context, "evaluation", num_chunks, [&](size_t chunk) {
    const size_t end = std::min((chunk + 1) * kChunk, static_cast<size_t>(count));
    for (size_t i = chunk * kChunk; i < end; ++i) body(static_cast<int>(i));
  });
}

}  // namespace limn
