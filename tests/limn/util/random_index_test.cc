// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/random_index.h"

#include <map>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(RandomIndex, IsBelowTheCount) {
  EXPECT_EQ(RandomIndex(0, 7), 0u);
  EXPECT_EQ(RandomIndex(0xffffffff, 7), 6u);
  EXPECT_EQ(RandomIndex(0xffffffff, 1), 0u);
  EXPECT_EQ(RandomIndex(0xffffffff, size_t{1} << 32), 0xffffffffu);
}

TEST(RandomSample, EveryChoiceIsEquallyLikely) {
  constexpr int kNumSamples = 10000;
  std::mt19937 random(1);
  std::map<std::vector<int>, int> counts;
  for (int k = 0; k < kNumSamples; ++k) {
    const std::vector<int> sample = RandomSample<int>({10, 11, 12, 13, 14}, 2, &random);
    ASSERT_EQ(sample.size(), 2u);
    ASSERT_LT(sample[0], sample[1]) << "in their order, none twice";
    ++counts[sample];
  }
  ASSERT_EQ(counts.size(), 10u);
  // Four standard deviations of a binomial distribution with p = 0.1.
  for (const auto& [sample, count] : counts) EXPECT_NEAR(count, kNumSamples / 10, 120);
}

TEST(RandomSample, IsTheSameOnAllPlatforms) {
  std::mt19937 random(1);
  EXPECT_EQ(RandomSample<int>({10, 11, 12, 13, 14, 15, 16, 17}, 3, &random),
            (std::vector<int>{14, 15, 16}));
}

TEST(RandomSample, IsAllOfFew) {
  std::mt19937 random(1);
  const std::vector<int> few = {3, 1, 2};
  EXPECT_EQ(RandomSample(few, 3, &random), few);
  EXPECT_EQ(RandomSample(few, 5, &random), few);
  EXPECT_THAT(RandomSample(few, 0, &random), ::testing::IsEmpty());
}

}  // namespace
}  // namespace limn
