// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/fork_hypotheses.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "limn/linking/continuation.h"
#include "support/synthetic_image.h"

namespace limn {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3f;

constexpr int kRow = 20;

// Straight rows of 20 edgels 1 px apart, with links of 5 votes along them.
struct Rows {
  std::vector<Edgel> edgels;
  std::vector<SideColors> colors;
  std::vector<EdgelLink> links;

  // Returns the id of the first edgel.
  EdgelId Add(const Vector2d& start, double angle_rad, float strength = 10,
              const Vector3f& bright_side = Vector3f(150, 150, 150)) {
    const auto first = static_cast<EdgelId>(edgels.size());
    for (int i = 0; i < kRow; ++i) {
      Edgel edgel;
      edgel.position_px = start + i * Vector2d(std::cos(angle_rad), std::sin(angle_rad));
      edgel.tangent_rad = angle_rad;
      edgel.strength = strength;
      edgel.position_sigma_px = 0.1f;
      edgels.push_back(edgel);
      colors.push_back({Vector3f(90, 90, 90), bright_side});
      if (i > 0) links.push_back({first + i - 1, first + i, 5});
    }
    return first;
  }
  void Link(EdgelId a, EdgelId b, int votes) { links.push_back({a, b, votes}); }

  Chaining MutualBest() const { return ChainMutualBest(edgels, links); }
  int Resolve(Chaining* chaining) const { return ResolveForks(edgels, colors, links, chaining); }
};

// A stem that ends at (0, 0), and two ways to go on from there; most votes are for the wrong one.
struct Fork : Rows {
  EdgelId stem_end;
  EdgelId right_way = kInvalidEdgel;
  EdgelId wrong_way = kInvalidEdgel;

  Fork() { stem_end = Add({-kRow + 1, 0}, 0) + kRow - 1; }

  void ExpectCorrected() {
    Link(stem_end, right_way, 2);
    Link(stem_end, wrong_way, 4);
    Chaining chaining = MutualBest();
    ASSERT_EQ(chaining.next[stem_end], wrong_way);
    EXPECT_EQ(Resolve(&chaining), 1);
    EXPECT_EQ(chaining.next[stem_end], right_way);
    EXPECT_EQ(chaining.prev[right_way], stem_end);
    EXPECT_EQ(chaining.prev[wrong_way], kInvalidEdgel);
    EXPECT_EQ(Resolve(&chaining), 0);
  }
};

TEST(ResolveForks, TheSmoothWay) {
  Fork fork;
  fork.wrong_way = fork.Add({0.95, 0.3}, 0.35);
  fork.right_way = fork.Add({1, 0}, 0);
  fork.ExpectCorrected();
}

TEST(ResolveForks, TheWayOfTheSameContrast) {
  Fork fork;
  fork.wrong_way = fork.Add({1, 0.1}, 0.1, 40);
  fork.right_way = fork.Add({1, -0.1}, -0.1, 10);
  fork.ExpectCorrected();
}

TEST(ResolveForks, TheWayOfTheSameColors) {
  Fork fork;
  fork.wrong_way = fork.Add({1, 0.1}, 0.1, 10, Vector3f(150, 40, 200));
  fork.right_way = fork.Add({1, -0.1}, -0.1, 10);
  fork.ExpectCorrected();
}

TEST(ResolveForks, TheLongWay) {
  // All alike, but one way ends after 2 px.
  Fork fork;
  fork.wrong_way = fork.Add({1, 0.1}, 0.1);
  fork.links.resize(fork.links.size() - kRow + 3);
  fork.right_way = fork.Add({1, -0.1}, -0.1);
  fork.ExpectCorrected();
}

TEST(ResolveForks, StaysWithoutGain) {
  Fork fork;
  const EdgelId voted = fork.Add({1, 0.1}, 0.1);
  const EdgelId other = fork.Add({1, -0.1}, -0.1);
  fork.Link(fork.stem_end, voted, 4);
  fork.Link(fork.stem_end, other, 2);
  Chaining chaining = fork.MutualBest();
  EXPECT_EQ(fork.Resolve(&chaining), 0);
  EXPECT_EQ(chaining.next[fork.stem_end], voted);
}

TEST(ResolveForks, BothWaysOfACrossing) {
  Rows rows;
  const EdgelId a_end = rows.Add({-kRow + 1, 0}, 0) + kRow - 1;
  const EdgelId b_end =
      rows.Add({-(kRow - 1) * std::cos(.4), 1 - (kRow - 1) * std::sin(.4)}, .4) + kRow - 1;
  const EdgelId a_next = rows.Add({1, 0}, 0);
  const EdgelId b_next = rows.Add({std::cos(.4), 1 + std::sin(.4)}, .4);
  rows.Link(a_end, b_next, 4);
  rows.Link(b_end, a_next, 4);
  rows.Link(a_end, a_next, 2);
  rows.Link(b_end, b_next, 2);
  Chaining chaining = rows.MutualBest();
  ASSERT_EQ(chaining.next[a_end], b_next);
  ASSERT_EQ(chaining.next[b_end], a_next);
  EXPECT_EQ(rows.Resolve(&chaining), 1);
  EXPECT_EQ(chaining.next[a_end], a_next);
  EXPECT_EQ(chaining.next[b_end], b_next);
}

TEST(ResolveForks, ShortcutsAreNoForks) {
  Rows rows;
  rows.Add({0, 0}, 0);
  rows.Link(4, 6, 1);
  Chaining chaining = rows.MutualBest();
  const std::vector<EdgelId> before = chaining.next;
  EXPECT_EQ(rows.Resolve(&chaining), 0);
  EXPECT_EQ(chaining.next, before);
}

TEST(Continuation, ScoreIsTheLengthOfAPerfectOne) {
  Rows rows;
  rows.Add({0, 0}, 0);
  rows.Add({kRow, 0}, 0);
  const Chaining chaining = rows.MutualBest();
  const Continuation continuation(rows.edgels, rows.colors, chaining);
  EXPECT_NEAR(continuation.Score(kRow - 1, kRow), kRow - 1, 1e-6);
  EXPECT_NEAR(continuation.Score(kRow - 1, kRow + 15), kRow - 16, 0.1);
  EXPECT_EQ(continuation.Score(kInvalidEdgel, 0), 0);
  EXPECT_EQ(continuation.Score(0, kInvalidEdgel), 0);
  EXPECT_TRUE(continuation.IsNearOnChain(3, 9));
  EXPECT_TRUE(continuation.IsNearOnChain(9, 3));
  EXPECT_FALSE(continuation.IsNearOnChain(3, kRow + 1));
}

TEST(MeasureSideColors, DarkAndBrightSide) {
  Image image = testing::ConstantImage(20, 20, {100, 20, 30});
  testing::Paint(testing::HalfPlane({10, 10}, {1, 0}), {200, 50, 60}, &image);
  Edgel edgel;
  edgel.position_px = {10, 10};
  edgel.tangent_rad = M_PI_2;  // the bright side is to the right
  const SideColors colors = MeasureSideColors({edgel}, &image)[0];
  EXPECT_EQ(colors[0], Vector3f(100, 20, 30));
  EXPECT_EQ(colors[1], Vector3f(200, 50, 60));
  EXPECT_EQ(MeasureSideColors({edgel}, nullptr)[0][1], Vector3f(0, 0, 0));
}

}  // namespace
}  // namespace limn
