// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/measured_depth.h"

#include <gtest/gtest.h>

#include "limn/topology/graph_fixture.h"

namespace limn {
namespace {

using testing::GraphOf;

constexpr double kFew = 1;
constexpr double kMany = 10;
constexpr double kNone = -1;

// A row of links between x = 0, 1, 2, ..., and, where `posts` says so, a measured one from it.
std::vector<bool> DoubtedInRow(const std::vector<double>& angles_deg,
                               const std::vector<int>& posts = {},
                               LinkDoubt doubt_of_posts = LinkDoubt::kNone) {
  std::vector<Polyline3d> links;
  std::vector<double> angle_deg = angles_deg;
  for (size_t k = 0; k < angles_deg.size(); ++k) {
    const auto x = static_cast<double>(k);
    links.push_back({{x, 0, 0}, {x + 1, 0, 0}});
  }
  for (const int at : posts) {
    links.push_back({{static_cast<double>(at), 0, 0}, {static_cast<double>(at), 1, 0}});
    angle_deg.push_back(kMany);
  }
  DrawingGraph graph = GraphOf(links);
  for (size_t l = angles_deg.size(); l < links.size(); ++l) graph.links[l].doubt = doubt_of_posts;
  DoubtUnmeasuredDepth(angle_deg, 2, &graph);
  std::vector<bool> doubted;
  for (size_t l = 0; l < angles_deg.size(); ++l) {
    doubted.push_back(graph.links[l].doubt == LinkDoubt::kDepth);
  }
  return doubted;
}

TEST(MeasuredDepthTest, ByTheAngleOfItsOwnViews) {
  EXPECT_EQ(DoubtedInRow({kFew}), (std::vector<bool>{true}));
  EXPECT_EQ(DoubtedInRow({2}), (std::vector<bool>{false}));
}

TEST(MeasuredDepthTest, ByBothEnds) {
  EXPECT_EQ(DoubtedInRow({kFew}, {0, 1}), (std::vector<bool>{false}));
  EXPECT_EQ(DoubtedInRow({kFew}, {0}), (std::vector<bool>{true}));
  EXPECT_EQ(DoubtedInRow({kMany, kFew, kMany}), (std::vector<bool>{false, false, false}));
}

TEST(MeasuredDepthTest, RunsHaveTwoEnds) {
  EXPECT_EQ(DoubtedInRow({kFew, kFew, kFew}, {0, 3}), (std::vector<bool>{false, false, false}));
  EXPECT_EQ(DoubtedInRow({kFew, kFew, kFew}, {0}), (std::vector<bool>{true, true, true}));
  EXPECT_EQ(DoubtedInRow({kFew, kFew, kFew}, {0, 1}), (std::vector<bool>{false, true, true}));
}

TEST(MeasuredDepthTest, ALoopHasOneEnd) {
  DrawingGraph graph =
      GraphOf({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 1}}});
  DoubtUnmeasuredDepth({kFew, kMany}, 2, &graph);
  EXPECT_EQ(graph.links[0].doubt, LinkDoubt::kDepth);
  EXPECT_EQ(graph.links[1].doubt, LinkDoubt::kNone);
}

TEST(MeasuredDepthTest, DoubtedLinksMeasureNothing) {
  EXPECT_EQ(DoubtedInRow({kFew}, {0, 1}, LinkDoubt::kChance), (std::vector<bool>{true}));
}

TEST(MeasuredDepthTest, WithoutAnAngleAsGoodAsWhatItMeets) {
  EXPECT_EQ(DoubtedInRow({kNone}), (std::vector<bool>{false}));
  EXPECT_EQ(DoubtedInRow({kNone, kFew}), (std::vector<bool>{true, true}));
  EXPECT_EQ(DoubtedInRow({kNone, kMany}), (std::vector<bool>{false, false}));
}

TEST(LeastAngleTest, AllLinksNeedAWideAngleWhereMostHaveNone) {
  EXPECT_EQ(LeastAngleDeg({1, 4, 4.9, 30, 60}, 2), 5);
  EXPECT_EQ(LeastAngleDeg({1, 4, 5.1, 30, 60}, 2), 2);
  EXPECT_EQ(LeastAngleDeg({1, 4, 4.9, 30, 60}, 7), 7);
}

TEST(LeastAngleTest, UnknownAnglesSayNothing) {
  EXPECT_EQ(LeastAngleDeg({-1, -1, -1, 30, 60}, 2), 2);
  EXPECT_EQ(LeastAngleDeg({-1, 3}, 2), 5);
  EXPECT_EQ(LeastAngleDeg({-1}, 2), 2);
  EXPECT_EQ(LeastAngleDeg({}, 2), 2);
}

}  // namespace
}  // namespace limn
