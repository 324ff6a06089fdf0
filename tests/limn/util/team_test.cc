#include "limn/util/team.h"

#include <barrier>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

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

struct Outcome {
  std::vector<std::string> values;
  int num_made = 0;  // by this rank
};

Outcome Make(size_t count, Team* team) {
  Outcome outcome;
  outcome.values.resize(count);
  RunContext context;
  context.num_threads = 1;
  context.team = team;
  TeamFor(
      context, "test", count,
      [&](size_t i) {
        outcome.values[i] = std::string(i % 7, 'x') + std::to_string(i);
        ++outcome.num_made;
      },
      [&](size_t i, ByteWriter* out) { out->PutString(outcome.values[i]); },
      [&](size_t i, ByteReader* in) { outcome.values[i] = in->GetString(); });
  return outcome;
}

class TeamSizes : public ::testing::TestWithParam<int> {};

// Fewer items than ranks, and several blocks of them.
TEST_P(TeamSizes, AllRanksHaveWhatOneProcessMakes) {
  const int num_ranks = GetParam();
  for (const size_t count : {0, 1, 2, 100, 9000}) {
    const Outcome alone = Make(count, nullptr);
    EXPECT_EQ(alone.num_made, static_cast<int>(count));
    Table table(num_ranks);
    std::vector<Outcome> of_rank(num_ranks);
    std::vector<std::thread> ranks;
    for (int rank = 0; rank < num_ranks; ++rank) {
      ranks.emplace_back([&, rank] {
        ThreadTeam team(rank, &table);
        of_rank[rank] = Make(count, &team);
      });
    }
    for (std::thread& rank : ranks) rank.join();
    // The last share of a block may be one item short.
    for (const Outcome& outcome : of_rank) {
      EXPECT_EQ(outcome.values, alone.values);
      EXPECT_NEAR(outcome.num_made, static_cast<double>(count) / num_ranks, 10);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Team, TeamSizes, ::testing::Values(1, 2, 3, 5));

}  // namespace
}  // namespace limn
