// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/parallel.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "limn/util/errors.h"
#include "limn/util/latest_stage.h"

namespace limn {
namespace {

RunContext Threads(int count) {
  RunContext context;
  context.num_threads = count;
  return context;
}

TEST(ParallelFor, RunsEachIndexOnce) {
  for (const int threads : {-1, 1, 2, 7}) {
    std::vector<int> visits(1000, 0);
    ParallelFor(Threads(threads), "test", visits.size(), [&](size_t i) { ++visits[i]; });
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), 1000) << threads;
  }
  ParallelFor(Threads(2), "test", 0, [](size_t) { FAIL() << "there is no index"; });
}

TEST(ParallelFor, ThreadsAreCapped) {
  std::mutex mutex;
  std::set<std::thread::id> threads;
  ParallelFor(Threads(10000), "test", 1000, [&](size_t) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::lock_guard lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  EXPECT_LE(threads.size(), std::max(16u, 2 * std::thread::hardware_concurrency()));
}

TEST(ParallelFor, ResultsDoNotDependOnThreads) {
  const auto compute = [](int threads) {
    std::vector<double> values(500);
    ParallelFor(Threads(threads), "test", values.size(), [&](size_t i) {
      for (int k = 1; k < 100; ++k) values[i] += 1.0 / (static_cast<double>(i) + k);
    });
    return values;
  };
  EXPECT_EQ(compute(1), compute(2));
}

TEST(ParallelFor, RunsMoreThreadsThanThereAreCoresWhenAsked) {
  const unsigned num_cores = std::thread::hardware_concurrency();
  std::mutex mutex;
  std::condition_variable another;
  std::set<std::thread::id> threads;
  // Threads may start late on a busy machine.
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  ParallelFor(Threads(static_cast<int>(num_cores) + 6), "test", 200, [&](size_t) {
    std::unique_lock lock(mutex);
    threads.insert(std::this_thread::get_id());
    another.notify_all();
    another.wait_until(lock, deadline, [&] { return threads.size() > num_cores; });
  });
  EXPECT_GT(threads.size(), num_cores);
}

TEST(ParallelFor, ExceptionOfABodyComesOut) {
  for (const int threads : {1, 2}) {
    try {
      ParallelFor(Threads(threads), "test", 100, [](size_t i) {
        if (i == 13) throw std::runtime_error("thirteen");
      });
      FAIL() << "the exception was lost";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "thirteen");
    }
  }
}

TEST(ParallelFor, CancellationStopsTheWork) {
  std::atomic<bool> cancelled = false;
  std::atomic<int> done = 0;
  RunContext context = Threads(2);
  context.cancelled = &cancelled;
  EXPECT_THROW(ParallelFor(context, "test", 100000,
                           [&](size_t) {
                             if (++done == 10) cancelled = true;
                           }),
               Cancelled);
  EXPECT_LT(done, 1000);
}

TEST(ParallelFor, ReportsEveryItemInOrder) {
  std::vector<size_t> reports;
  RunContext context = Threads(2);
  context.progress = [&](const char* stage, size_t done, size_t total) {
    EXPECT_EQ(std::string(stage), "drawing");
    EXPECT_EQ(total, 50u);
    reports.push_back(done);
  };
  ParallelFor(context, "drawing", 50, [](size_t) {});
  std::vector<size_t> expected(50);
  std::iota(expected.begin(), expected.end(), 1);
  EXPECT_EQ(reports, expected);
}

TEST(LatestStage, IsThatOfTheLoopThatBeganLast) {
  ParallelFor({}, "first", 1, [](size_t) { EXPECT_EQ(LatestStage(), "first"); });
  ParallelFor({}, "second", 0, [](size_t) {});
  EXPECT_EQ(LatestStage(), "second");
}

}  // namespace
}  // namespace limn
