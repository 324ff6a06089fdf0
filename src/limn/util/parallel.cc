// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/parallel.h"

#include <algorithm>
#include <mutex>
#include <optional>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

#include "limn/util/errors.h"
#include "limn/util/latest_stage.h"

namespace limn {
namespace {

// What a parallel loop promises to its bodies: they run after it began and before it ends. oneTBB
// is not built with the thread sanitizer, which would not see that and take every result for a
// race; they say nothing about the order between bodies. Nothing at all in other builds.
class LoopOrder {
 public:
  LoopOrder() { Release(&begin_); }
  ~LoopOrder() { Acquire(&end_); }
  LoopOrder(const LoopOrder&) = delete;
  LoopOrder& operator=(const LoopOrder&) = delete;

  class Body {
   public:
    explicit Body(LoopOrder* order) : order_(order) { Acquire(&order->begin_); }
    ~Body() { Release(&order_->end_); }
    Body(const Body&) = delete;
    Body& operator=(const Body&) = delete;

   private:
    LoopOrder* order_;
  };

 private:
#ifdef __SANITIZE_THREAD__
  static void Acquire(char* place) { __tsan_acquire(place); }
  static void Release(char* place) { __tsan_release(place); }
#else
  static void Acquire(char*) {}
  static void Release(char*) {}
#endif
  char begin_ = 0;
  char end_ = 0;
};

// More threads than cores gain nothing, and many of them cost memory.
int NumThreads(const RunContext& context) {
  const int num_cores = tbb::info::default_concurrency();
  return context.num_threads > 0 ? std::min(context.num_threads, std::max(16, 2 * num_cores))
                                 : num_cores;
}

}  // namespace

RunContext PartOf(const RunContext& context, size_t begin, size_t total) {
  RunContext part = context;
  if (context.progress) {
    part.progress = [progress = context.progress, begin, total](const char* stage, size_t done,
                                                                size_t) {
      progress(stage, begin + done, total);
    };
  }
  return part;
}

void ThrowIfCancelled(const RunContext& context) {
  if (context.cancelled && context.cancelled->load(std::memory_order_relaxed)) throw Cancelled();
}

void ParallelFor(const RunContext& context, const char* stage, size_t count,
                 const std::function<void(size_t)>& body) {
  SetLatestStage(stage);
  std::mutex progress_mutex;
  size_t done = 0;
  LoopOrder order;
  const auto run_one = [&](size_t i) {
    const LoopOrder::Body in_order(&order);
    ThrowIfCancelled(context);
    body(i);
    if (!context.progress) return;
    const std::lock_guard lock(progress_mutex);
    context.progress(stage, ++done, count);
  };
  // oneTBB runs no more threads than there are cores unless it is allowed to.
  std::optional<tbb::global_control> allowed;
  const int num_threads = NumThreads(context);
  if (num_threads > tbb::info::default_concurrency()) {
    allowed.emplace(tbb::global_control::max_allowed_parallelism, num_threads);
  }
  tbb::task_arena arena(num_threads);
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
