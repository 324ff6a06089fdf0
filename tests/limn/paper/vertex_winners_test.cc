// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/vertex_winners.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

// A hypothesis over the vertices [begin, end), each of this weight.
SupportedHypothesis Hypothesis(int begin, int end, double weight) {
  SupportedHypothesis supported;
  for (int vertex = begin; vertex < end; ++vertex) {
    HypothesisSample sample;
    sample.vertex = vertex;
    supported.hypothesis.samples.push_back(sample);
    supported.support.weighted.push_back(weight);
  }
  return supported;
}

TEST(VertexWinnersTest, TheMostSupportOverTheWholeLengthWinsWhereItClearlyHas) {
  // Totals of 16, 10 and 9; the second has the most per vertex.
  const std::vector<SupportedHypothesis> rivals = {Hypothesis(0, 8, 2), Hypothesis(6, 8, 5),
                                                   Hypothesis(7, 10, 3)};
  using Winners = std::vector<int>;
  EXPECT_EQ(FindVertexWinners(rivals, 11, 1.5), (Winners{0, 0, 0, 0, 0, 0, 0, 0, 2, 2, -1}));
  EXPECT_EQ(FindVertexWinners(rivals, 11, 1.7), (Winners{0, 0, 0, 0, 0, 0, -1, -1, 2, 2, -1}));
}

TEST(VertexWinnersTest, TheOrderOfTheRivalsDoesNotMatter) {
  EXPECT_EQ(
      FindVertexWinners({Hypothesis(0, 1, 1), Hypothesis(0, 1, 4), Hypothesis(0, 1, 3)}, 1, 1.2),
      std::vector<int>{1});
  EXPECT_EQ(
      FindVertexWinners({Hypothesis(0, 1, 3), Hypothesis(0, 1, 4), Hypothesis(0, 1, 1)}, 1, 1.5),
      std::vector<int>{-1});
}

TEST(VertexWinnersTest, EqualOnesAndThoseWithoutSupportDoNotWin) {
  EXPECT_EQ(FindVertexWinners({Hypothesis(0, 1, 4), Hypothesis(0, 1, 4)}, 1, 1),
            std::vector<int>{-1});
  EXPECT_EQ(FindVertexWinners({Hypothesis(0, 1, 0)}, 1, 1), std::vector<int>{-1});
}

}  // namespace
}  // namespace limn
