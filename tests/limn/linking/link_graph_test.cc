// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/link_graph.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

std::vector<Edgel> Row(int count) {
  std::vector<Edgel> edgels(count);
  for (int i = 0; i < count; ++i) {
    edgels[i].position_px = {static_cast<double>(i), 0};
    edgels[i].position_sigma_px = 0.05f;
  }
  return edgels;
}

TEST(ChainMutualBest, MostVotesThenShortest) {
  const std::vector<Edgel> edgels = Row(4);
  // 0 prefers 2 (more votes), 2 prefers 1 behind it: no mutual choice for 0.
  Chaining chaining = ChainMutualBest(edgels, {{0, 1, 2}, {0, 2, 5}, {1, 2, 6}, {2, 3, 1}});
  EXPECT_EQ(chaining.next, (std::vector<EdgelId>{-1, 2, 3, -1}));
  EXPECT_EQ(chaining.prev, (std::vector<EdgelId>{-1, -1, 1, 2}));
  // Equal votes: the shorter links win.
  chaining = ChainMutualBest(edgels, {{0, 1, 5}, {0, 2, 5}, {1, 2, 5}});
  EXPECT_EQ(chaining.next, (std::vector<EdgelId>{1, 2, -1, -1}));
}

TEST(ChainMutualBest, SidewaysLinksAreNoContinuation) {
  std::vector<Edgel> edgels = Row(2);
  edgels[1].position_px = {0, 1};
  EXPECT_EQ(ChainMutualBest(edgels, {{0, 1, 9}}).next, (std::vector<EdgelId>{-1, -1}));
  // Ahead of both: each would follow the other.
  edgels[1].position_px = {1, 0};
  edgels[1].tangent_rad = M_PI;
  EXPECT_EQ(ChainMutualBest(edgels, {{0, 1, 9}}).next, (std::vector<EdgelId>{-1, -1}));
}

TEST(TraceChains, OpenAndClosed) {
  Chaining chaining(7);
  chaining.Join(5, 1);  // 5 -> 1 -> 3
  chaining.Join(1, 3);
  chaining.Join(4, 2);  // cycle 2 -> 6 -> 4 -> 2
  chaining.Join(2, 6);
  chaining.Join(6, 4);
  std::vector<CurveFragment> chains = TraceChains(chaining);
  ASSERT_EQ(chains.size(), 2u);
  EXPECT_EQ(chains[0].edgel_ids, (std::vector<EdgelId>{2, 6, 4}));
  EXPECT_TRUE(chains[0].closed);
  EXPECT_EQ(chains[1].edgel_ids, (std::vector<EdgelId>{5, 1, 3}));
  EXPECT_FALSE(chains[1].closed);

  chaining.BreakAfter(6);
  chains = TraceChains(chaining);
  EXPECT_EQ(chains[0].edgel_ids, (std::vector<EdgelId>{4, 2, 6}));
  EXPECT_FALSE(chains[0].closed);
}

TEST(BuildLinkGraph, StraightRowLinksNeighbors) {
  int64_t curvelets = 0;
  const std::vector<EdgelLink> links = BuildLinkGraph(Row(10), {}, &curvelets);
  EXPECT_EQ(curvelets, 10);
  ASSERT_EQ(links.size(), 9u);
  for (int i = 0; i < 9; ++i) {
    EXPECT_EQ(links[i].a, i);
    EXPECT_EQ(links[i].b, i + 1);
  }
  EXPECT_GT(links[4].votes, links[0].votes);
}

}  // namespace
}  // namespace limn
