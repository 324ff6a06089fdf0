#include "limn/util/parallel.h"

#include <mutex>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "limn/util/errors.h"

namespace limn {

void ThrowIfCancelled(const RunContext& context) {
  if (context.cancelled && context.cancelled->load(std::memory_order_relaxed)) throw Cancelled();
}

void ParallelFor(const RunContext& context, const char* stage, size_t count,
                 const std::function<void(size_t)>& body) {
  std::mutex progress_mutex;
  size_t done = 0;
  const auto run_one = [&](size_t i) {
    ThrowIfCancelled(context);
    body(i);
    if (!context.progress) return;
    const std::lock_guard lock(progress_mutex);
    context.progress(stage, ++done, count);
  };
  tbb::task_arena arena(context.num_threads > 0 ? context.num_threads
                                                : static_cast<int>(tbb::task_arena::automatic));
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<size_t>(0, count, 1),
        [&](const tbb::blocked_range<size_t>& range) {
          for (size_t i = range.begin(); i != range.end(); ++i) run_one(i);
        },
        tbb::simple_partitioner());
  });
}

}  // namespace limn
