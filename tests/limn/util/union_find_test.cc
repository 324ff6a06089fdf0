// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/union_find.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(UnionFind, RepresentativeIsTheSmallestMember) {
  UnionFind sets(6);
  EXPECT_TRUE(sets.Union(5, 3));
  EXPECT_TRUE(sets.Union(3, 4));
  EXPECT_FALSE(sets.Union(4, 5));
  EXPECT_EQ(sets.Find(5), 3);
  EXPECT_EQ(sets.Find(0), 0);
  EXPECT_TRUE(sets.Union(1, 5));
  EXPECT_EQ(sets.Find(4), 1);
}

TEST(UnionFind, OrderOfUnionsDoesNotMatter) {
  std::vector<std::pair<int, int>> pairs = {{0, 9}, {9, 4}, {2, 7}, {7, 8}, {5, 6}, {8, 2}};
  std::mt19937 random(5);
  std::vector<int> first;
  for (int repeat = 0; repeat < 20; ++repeat) {
    std::shuffle(pairs.begin(), pairs.end(), random);
    UnionFind sets(10);
    for (const auto& [a, b] : pairs) sets.Union(a, b);
    std::vector<int> representatives;
    for (int i = 0; i < 10; ++i) representatives.push_back(sets.Find(i));
    if (first.empty()) first = representatives;
    EXPECT_EQ(representatives, first);
  }
  EXPECT_EQ(first, (std::vector<int>{0, 1, 2, 3, 0, 5, 5, 2, 2, 0}));
}

}  // namespace
}  // namespace limn
