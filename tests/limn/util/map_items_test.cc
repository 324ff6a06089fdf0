// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/map_items.h"

#include <atomic>
#include <barrier>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "limn/util/team.h"

namespace limn {
namespace {

// Where the ranks of a team, each a thread here, lay down what they exchange.
class Table {
 public:
  explicit Table(int num_ranks) : bytes_(num_ranks), all_here_(num_ranks) {}

  std::vector<std::string> Exchange(int rank, const std::string& mine) {
    bytes_[rank] = mine;
    all_here_.arrive_and_wait();
    std::vector<std::string> all = bytes_;
    all_here_.arrive_and_wait();
    return all;
  }
  int size() const { return static_cast<int>(bytes_.size()); }

 private:
  std::vector<std::string> bytes_;
  std::barrier<> all_here_;
};

class ThreadTeam : public Team {
 public:
  ThreadTeam(int rank, Table* table) : rank_(rank), table_(table) {}
  int Rank() const override { return rank_; }
  int Size() const override { return table_->size(); }
  std::vector<std::string> Exchange(const std::string& mine) override {
    return table_->Exchange(rank_, mine);
  }

 private:
  int rank_;
  Table* table_;
};

RunContext ContextOf(Team* team) {
  RunContext context;
  context.num_threads = 2;
  context.team = team;
  return context;
}

struct Result {
  std::string text;
  std::vector<double> numbers;
};

struct Outcome {
  std::vector<std::string> texts;
  std::vector<double> numbers;
  int num_made = 0;  // by this rank
};

Outcome Make(size_t count, Team* team) {
  std::atomic<int> num_made = 0;
  const auto results = MapItems(ContextOf(team), "test", count, [&](size_t i) {
    ++num_made;
    return Result{std::string(i % 7, 'x') + std::to_string(i), {0.5 * i, std::sqrt(i)}};
  });
  Outcome outcome{{}, {}, num_made};
  for (const Result& result : results) {
    outcome.texts.push_back(result.text);
    outcome.numbers.insert(outcome.numbers.end(), result.numbers.begin(), result.numbers.end());
  }
  return outcome;
}

// Runs body(team) on every rank of a team.
void RunRanks(int num_ranks, const std::function<void(int, Team*)>& body) {
  Table table(num_ranks);
  std::vector<std::thread> ranks;
  for (int rank = 0; rank < num_ranks; ++rank) {
    ranks.emplace_back([&, rank] {
      ThreadTeam team(rank, &table);
      body(rank, &team);
    });
  }
  for (std::thread& rank : ranks) rank.join();
}

class TeamSizes : public ::testing::TestWithParam<int> {};

// Fewer items than ranks, and several blocks of them.
TEST_P(TeamSizes, AllRanksHaveWhatOneProcessMakes) {
  const int num_ranks = GetParam();
  for (const size_t count : {0, 1, 2, 100, 9000}) {
    const Outcome alone = Make(count, nullptr);
    EXPECT_EQ(alone.num_made, static_cast<int>(count));
    std::vector<Outcome> of_rank(num_ranks);
    RunRanks(num_ranks, [&](int rank, Team* team) { of_rank[rank] = Make(count, team); });
    // The last share of a block may be one item short.
    for (const Outcome& outcome : of_rank) {
      EXPECT_EQ(outcome.texts, alone.texts);
      EXPECT_EQ(outcome.numbers, alone.numbers);
      EXPECT_NEAR(outcome.num_made, static_cast<double>(count) / num_ranks, 10);
    }
  }
}

TEST_P(TeamSizes, BlocksAreTakenInOrder) {
  const int num_ranks = GetParam();
  constexpr size_t kCount = 9000;
  std::vector<std::vector<size_t>> taken(num_ranks);
  RunRanks(num_ranks, [&](int rank, Team* team) {
    MapItemsInBlocks(
        ContextOf(team), "test", kCount, [](size_t i) { return 3 * i; },
        [&](size_t i, size_t result) {
          EXPECT_EQ(result, 3 * i);
          taken[rank].push_back(i);
        });
  });
  std::vector<size_t> all(kCount);
  std::iota(all.begin(), all.end(), 0);
  for (const auto& of_rank : taken) EXPECT_EQ(of_rank, all);
}

// Results are handed over before more are made, and progress covers the whole loop.
TEST(MapItemsInBlocks, HoldsOneBlock) {
  constexpr size_t kCount = 10000;
  std::atomic<size_t> num_made = 0;
  size_t num_taken = 0;
  size_t most_held = 0;
  RunContext context = ContextOf(nullptr);
  size_t last_done = 0;
  context.progress = [&](const char*, size_t done, size_t total) {
    EXPECT_EQ(done, last_done + 1);
    EXPECT_EQ(total, kCount);
    last_done = done;
  };
  MapItemsInBlocks(
      context, "test", kCount,
      [&](size_t i) {
        ++num_made;
        return i;
      },
      [&](size_t, size_t) {
        most_held = std::max(most_held, num_made - num_taken);
        ++num_taken;
      });
  EXPECT_EQ(num_taken, kCount);
  EXPECT_EQ(last_done, kCount);
  EXPECT_LT(most_held, kCount / 2);
}

INSTANTIATE_TEST_SUITE_P(Team, TeamSizes, ::testing::Values(1, 2, 3, 5));

}  // namespace
}  // namespace limn
