// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/kept_runs.h"

#include <string>

#include <gtest/gtest.h>

namespace limn {
namespace {

// "##..#": 1 1 0 0 1.
std::vector<uint8_t> Flags(const std::string& text) {
  std::vector<uint8_t> flags;
  for (const char c : text) flags.push_back(c == '#');
  return flags;
}

using Runs = std::vector<CellRun>;

TEST(KeptRuns, OfAnOpenCurve) {
  EXPECT_EQ(KeptRuns(Flags(""), false, 9, 0), Runs());
  EXPECT_EQ(KeptRuns(Flags("...."), false, 9, 0), Runs());
  EXPECT_EQ(KeptRuns(Flags("####"), false, 0, 4), (Runs{{0, 4}}));
  EXPECT_EQ(KeptRuns(Flags("####"), false, 0, 5), Runs());
  EXPECT_EQ(KeptRuns(Flags(".##..#."), false, 1, 0), (Runs{{1, 3}, {5, 6}}));
  EXPECT_EQ(KeptRuns(Flags(".##..#."), false, 1, 2), (Runs{{1, 3}}));
  // Gaps are closed first, but not those at the ends.
  EXPECT_EQ(KeptRuns(Flags(".##..#."), false, 2, 5), (Runs{{1, 6}}));
}

TEST(KeptRuns, OfAClosedCurveGoRoundItsStart) {
  EXPECT_EQ(KeptRuns(Flags("##...#"), true, 0, 3), (Runs{{5, 8}}));
  EXPECT_EQ(KeptRuns(Flags("##...#"), false, 0, 2), (Runs{{0, 2}}));
  EXPECT_EQ(KeptRuns(Flags(".#...#"), true, 1, 3), (Runs{{5, 8}}));
  EXPECT_EQ(KeptRuns(Flags("...###"), true, 1, 3), (Runs{{3, 6}}));
  EXPECT_EQ(KeptRuns(Flags("######"), true, 0, 6), (Runs{{0, 6}}));
  EXPECT_EQ(KeptRuns(Flags("......"), true, 9, 0), Runs());
  EXPECT_EQ(KeptRuns(Flags(""), true, 9, 0), Runs());
}

// Short gaps all round: all but the longest are closed.
TEST(KeptRuns, OfAClosedCurveKeepOneGap) {
  EXPECT_EQ(KeptRuns(Flags("#.##..#.#"), true, 2, 0), (Runs{{6, 13}}));
}

}  // namespace
}  // namespace limn
