// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/true_chains.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "limn/evaluation/plain_curves.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

using testing::Curves;

constexpr double kTolerance = 0.01;

TrueChains Chains(const CurveSet& truth) {
  return FindTrueChains(truth, [](const Eigen::Vector3d&) { return kTolerance; });
}

// Numbers of arms of all nodes, ascending.
std::vector<int> ArmCounts(const TrueChains& chains) {
  std::vector<int> counts;
  for (const TrueNode& node : chains.nodes) counts.push_back(static_cast<int>(node.arms.size()));
  std::sort(counts.begin(), counts.end());
  return counts;
}

// Lengths of all chains, ascending.
std::vector<double> Lengths(const TrueChains& chains) {
  std::vector<double> lengths;
  for (const TrueChain& chain : chains.chains) lengths.push_back(chain.length);
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

void ExpectLengths(const TrueChains& chains, const std::vector<double>& expected) {
  const std::vector<double> lengths = Lengths(chains);
  ASSERT_EQ(lengths.size(), expected.size());
  for (size_t i = 0; i < lengths.size(); ++i) EXPECT_NEAR(lengths[i], expected[i], 1e-9);
}

Polyline3d ClosedCircle(int num_segments) {
  Polyline3d circle;
  for (int i = 0; i < num_segments; ++i) {
    const double angle = 2 * M_PI * i / num_segments;
    circle.push_back({std::cos(angle), std::sin(angle), 0});
  }
  circle.push_back(circle.front());
  return circle;
}

// From (-1, 0, 0) over the origin, turning by this much, 1 long on either side.
Polyline3d Bend(double turn_deg) {
  return {{-1, 0, 0}, {0, 0, 0}, {std::cos(turn_deg * kDeg), std::sin(turn_deg * kDeg), 0}};
}

TEST(TrueChains, NothingGivesNothing) {
  EXPECT_TRUE(Chains(CurveSet()).chains.empty());
  CurveSet points;
  points.points = {{0, 0, 0}, {1, 0, 0}};
  EXPECT_TRUE(Chains(points).chains.empty());
  const TrueChains degenerate = Chains(Curves({{}, {{1, 1, 1}}, {{2, 2, 2}, {2, 2, 2}}}));
  EXPECT_TRUE(degenerate.chains.empty());
  EXPECT_TRUE(degenerate.nodes.empty());
  EXPECT_EQ(degenerate.pieces.size(), 3u);
}

TEST(TrueChains, CutAtCornersOfMoreThan40Degrees) {
  const TrueChains sharp = Chains(Curves({Bend(41)}));
  ExpectLengths(sharp, {1, 1});
  EXPECT_EQ(ArmCounts(sharp), (std::vector{1, 1, 2}));
  const TrueChains smooth = Chains(Curves({Bend(39)}));
  ExpectLengths(smooth, {2});
  EXPECT_EQ(ArmCounts(smooth), (std::vector{1, 1}));
}

TEST(TrueChains, GoOnOverNodesOfTwoSmoothEnds) {
  // The second one runs the other way and begins within the tolerance of the first one's end.
  const TrueChains chains =
      Chains(Curves({{{0, 0, 0}, {1, 0, 0}}, {{3, 0, 0}, {1, 0.5 * kTolerance, 0}}}));
  ASSERT_EQ(chains.chains.size(), 1u);
  EXPECT_NEAR(chains.chains[0].length, 3, 1e-4);
  EXPECT_EQ(chains.nodes.size(), 2u);
  EXPECT_EQ(
      Chains(Curves({{{0, 0, 0}, {1, 0, 0}}, {{3, 0, 0}, {1, 1.5 * kTolerance, 0}}})).chains.size(),
      2u);
}

TEST(TrueChains, FoldsEndThem) {
  const TrueChains copies = Chains(Curves({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {1, 0, 0}}}));
  ExpectLengths(copies, {1, 1});
  EXPECT_EQ(ArmCounts(copies), (std::vector{2, 2}));
}

TEST(TrueChains, ClosedCurves) {
  const TrueChains circle = Chains(Curves({ClosedCircle(24)}));
  ExpectLengths(circle, {48 * std::sin(M_PI / 24)});
  EXPECT_TRUE(circle.nodes.empty());
  // A square that begins in the middle of a side.
  const TrueChains square =
      Chains(Curves({{{0.5, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {0.5, 0, 0}}}));
  ExpectLengths(square, {1, 1, 1, 1});
  EXPECT_EQ(ArmCounts(square), (std::vector{2, 2, 2, 2}));
  // A drop: closed, with one corner.
  Polyline3d drop = {{2, 0, 0}};
  for (int deg = 60; deg <= 300; deg += 15) {
    drop.push_back({std::cos(deg * kDeg), std::sin(deg * kDeg), 0});
  }
  drop.push_back(drop.front());
  EXPECT_EQ(Chains(Curves({drop})).chains.size(), 1u);
  EXPECT_EQ(ArmCounts(Chains(Curves({drop}))), (std::vector{2}));
}

TEST(TrueChains, EndOnAnotherCurveCutsIt) {
  const Polyline3d bar = {{-1, 0, 0}, {1, 0, 0}};
  const TrueChains tee = Chains(Curves({bar, {{0, 0.5 * kTolerance, 0}, {0, 1, 0}}}));
  ExpectLengths(tee, {1 - 0.5 * kTolerance, 1, 1});
  EXPECT_EQ(ArmCounts(tee), (std::vector{1, 1, 1, 3}));
  const TrueChains apart = Chains(Curves({bar, {{0, 1.5 * kTolerance, 0}, {0, 1, 0}}}));
  EXPECT_EQ(ArmCounts(apart), (std::vector{1, 1, 1, 1}));
}

TEST(TrueChains, EndOnTheCurveItselfCutsIt) {
  // A "6": a stem, and a circle that ends where it leaves the stem.
  Polyline3d six = {{-1, 2, 0}};
  for (int deg = 180; deg <= 540; deg += 5) {
    six.push_back({std::cos(deg * kDeg), std::sin(deg * kDeg), 0});
  }
  const TrueChains chains = Chains(Curves({six}));
  ExpectLengths(chains, {2, 144 * std::sin(2.5 * kDeg)});
  EXPECT_EQ(ArmCounts(chains), (std::vector{1, 3}));
}

TEST(TrueChains, OwnJunctionsCut) {
  const Polyline3d line = {{-1, 0, 0}, {1, 0, 0}};
  const TrueChains cut = Chains(Curves({line}, {{{0.25, 0, 0}, 3}}));
  ExpectLengths(cut, {0.75, 1.25});
  const auto junction = std::find_if(cut.nodes.begin(), cut.nodes.end(),
                                     [](const TrueNode& node) { return node.degree == 3; });
  ASSERT_NE(junction, cut.nodes.end());
  EXPECT_EQ(junction->arms.size(), 2u);
  EXPECT_EQ(junction->position_in_world, Eigen::Vector3d(0.25, 0, 0));
  // A node of degree 2 is no junction.
  ExpectLengths(Chains(Curves({line}, {{{0.25, 0, 0}, 2}})), {2});
}

// The arms of the one junction, of degree 3, of a line along x and further curves.
size_t ArmsWith(std::vector<Polyline3d> others) {
  others.push_back({{-1, 0, 0}, {1, 0, 0}});
  const TrueChains chains = Chains(Curves(others, {{{0, 0, 0}, 3}}));
  for (const TrueNode& node : chains.nodes) {
    if (node.degree == 3) return node.arms.size();
  }
  return 0;
}

TEST(TrueChains, ArmsAcrossGaps) {
  const Polyline3d across_gap = {{0, 15 * kTolerance, 0}, {0, 1, 0}};
  EXPECT_EQ(ArmsWith({across_gap}), 3u);
  EXPECT_EQ(ArmsWith({{{0, 17 * kTolerance, 0}, {0, 1, 0}}}), 2u);
  // Passing by.
  EXPECT_EQ(ArmsWith({{{0, 10 * kTolerance, 0}, {0, 10 * kTolerance, 1}}}), 2u);
  // In the direction of an arm that is there.
  EXPECT_EQ(ArmsWith({{{10 * kTolerance, 1.5 * kTolerance, 0}, {1, 0.1, 0}}}), 2u);
  // The junction has all its arms.
  EXPECT_EQ(ArmsWith({across_gap, {{0, 0, 0}, {0, -1, 0}}}), 3u);
  // A node of degree 2 is no junction.
  const TrueChains chains = Chains(Curves({{{-1, 0, 0}, {1, 0, 0}}, across_gap}, {{{0, 0, 0}, 2}}));
  EXPECT_EQ(ArmCounts(chains), (std::vector{0, 1, 1, 1, 1}));
}

TEST(TrueChains, SamplesKnowTheirPlace) {
  // One chain: 1 along the first polyline, 2 backwards along the second; a corner; 1 up.
  const CurveSet truth =
      Curves({{{0, 0, 0}, {1, 0, 0}}, {{3, 1, 0}, {3, 0, 0}, {1, 0, 0}}, {{7, 7, 7}}});
  const TrueChains chains = Chains(truth);
  ASSERT_EQ(chains.chains.size(), 2u);
  const CurveSamples samples(truth, [](const Polyline3d&) { return 0.1; });
  const std::vector<ChainPlace> places = PlacesOnChains(chains, samples);
  ASSERT_EQ(static_cast<int>(places.size()), samples.size());
  for (int i = 0; i < samples.size(); ++i) {
    const Eigen::Vector3d& position = samples.Position(i);
    if (position.x() > 6) {
      EXPECT_EQ(places[i].chain, -1);
      continue;
    }
    ASSERT_GE(places[i].chain, 0);
    const TrueChain& chain = chains.chains[places[i].chain];
    EXPECT_NEAR(chain.length, position.y() > 0 ? 1 : 3, 1e-9);
    const Polyline3d part = CutPolyline(chain.points, 0, places[i].arc);
    EXPECT_NEAR((part.back() - position).norm(), 0, 1e-9);
  }
  const CurveSamples nothing(CurveSet(), [](const Polyline3d&) { return 0.1; });
  EXPECT_TRUE(PlacesOnChains(chains, nothing).empty());
}

TEST(DirectionFromEnd, LooksAsFarAsItIsTold) {
  const Polyline3d hook = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  EXPECT_NEAR((DirectionFromEnd(hook, false, 0.5) - Eigen::Vector3d(1, 0, 0)).norm(), 0, 1e-12);
  const Eigen::Vector3d diagonal = Eigen::Vector3d(1, 1, 0).normalized();
  EXPECT_NEAR((DirectionFromEnd(hook, false, 2) - diagonal).norm(), 0, 1e-12);
  EXPECT_NEAR((DirectionFromEnd(hook, false, 9) - diagonal).norm(), 0, 1e-12);
  EXPECT_NEAR((DirectionFromEnd(hook, true, 1) - Eigen::Vector3d(0, -1, 0)).norm(), 0, 1e-12);
  EXPECT_TRUE(DirectionFromEnd({{1, 1, 1}, {1, 1, 1}}, false, 1).isZero(0));
  EXPECT_TRUE(DirectionFromEnd({}, false, 1).isZero(0));
}

}  // namespace
}  // namespace limn
