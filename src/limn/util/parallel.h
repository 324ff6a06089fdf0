#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace limn {

class Team;

// How a stage runs: its threads, who hears of its progress, who may stop it. Never changes a
// result.
struct RunContext {
  // Number of threads; -1 means all cores.
  int num_threads = -1;
  // Called with (stage, items done, items in all), from any thread, one call at a time.
  std::function<void(const char* stage, size_t done, size_t total)> progress;
  // When set and true, ThrowIfCancelled throws.
  const std::atomic<bool>* cancelled = nullptr;
  // When set, the processes that share out the loops that are run by MapItems (map_items.h).
  Team* team = nullptr;
};

// The context of a loop over items [begin, ...) of a longer one of `total`, which is what its
// progress tells of.
RunContext PartOf(const RunContext& context, size_t begin, size_t total);

// Throws Cancelled if the run is to stop: for long loops that are not parallel, and inside of long
// items.
void ThrowIfCancelled(const RunContext& context);

// Run body(i) for i in [0, count), each index once, in no particular order. No item begins when the
// run is to stop: Cancelled is thrown. Results are independent
// of the number of threads if body(i) writes only what belongs to i. The first exception thrown by
// a body is rethrown here after the others have stopped. `stage` labels the progress reports.
void ParallelFor(const RunContext& context, const char* stage, size_t count,
                 const std::function<void(size_t)>& body);

}  // namespace limn
