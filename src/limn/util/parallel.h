// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace limn {

class Team;

// How a stage runs: threads, progress, cancellation, team. Never changes a result.
struct RunContext {
  // Number of threads; -1 means all cores. Loops use at most two per core, or 16.
  int num_threads = -1;
  // Called with (stage, items done, items in total) from any thread, one call at a time.
  std::function<void(const char* stage, size_t done, size_t total)> progress;
  // When set and true, ThrowIfCancelled throws.
  const std::atomic<bool>* cancelled = nullptr;
  // When set, the processes that share the loops of MapItems (map_items.h).
  Team* team = nullptr;
};

// The context of a loop over the items from `begin` of a longer loop of `total` items, for which it
// reports progress.
RunContext PartOf(const RunContext& context, size_t begin, size_t total);

// Throws Cancelled if the run was asked to stop: for long serial loops, and inside long items.
void ThrowIfCancelled(const RunContext& context);

// Runs body(i) for i in [0, count), each index once, in any order. Throws Cancelled, without
// starting further items, if the run is to stop. Results are independent of the number of threads
// if body(i) writes only data of i. The first exception thrown by a body is rethrown here after the
// others have stopped. `stage` labels the progress reports.
void ParallelFor(const RunContext& context, const char* stage, size_t count,
                 const std::function<void(size_t)>& body);

}  // namespace limn
