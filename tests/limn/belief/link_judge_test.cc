// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/link_judge.h"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "limn/belief/belief_scene.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using testing::BeliefScene;
using testing::FrontalPoint;
using testing::Segment;

BeliefResult Judged(const BeliefScene& scene, const std::vector<uint8_t>& fitted = {},
                    const BeliefOptions& options = {}, int num_threads = 1) {
  const std::vector<ImageCurves> curves = scene.Curves();
  RunContext context;
  context.num_threads = num_threads;
  BeliefResult result =
      JudgeLinks({{scene.views, curves}, scene.graph, fitted, testing::kShowingGate}, options,
                 TopologyOptions(), context);
  testing::ExpectValid(result.graph);
  return result;
}

using Doubts = std::vector<LinkDoubt>;

// Also expects that exactly the doubted links are tentative.
Doubts DoubtsOf(const DrawingGraph& graph) {
  Doubts doubts;
  for (const DrawingLink& link : graph.links) {
    EXPECT_EQ(link.tentative, link.doubt != LinkDoubt::kNone);
    doubts.push_back(link.doubt);
  }
  return doubts;
}

Doubts DoubtsOf(const BeliefScene& scene, const std::vector<uint8_t>& fitted = {}) {
  return DoubtsOf(Judged(scene, fitted).graph);
}

TEST(JudgeLinksTest, EdgesThatManyViewsShowAreBelieved) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0));
  scene.Add(FrontalPoint(-50, 40), FrontalPoint(50, 40), 8);
  EXPECT_EQ(DoubtsOf(scene), (Doubts{LinkDoubt::kNone, LinkDoubt::kNone}));
}

TEST(JudgeLinksTest, TwoOfSixteenViewsAreChance) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0), 2);
  EXPECT_EQ(DoubtsOf(scene), (Doubts{LinkDoubt::kChance}));
}

TEST(JudgeLinksTest, APreciseLinkNeedsFewerViews) {
  for (const double sigma_px : {0.4, 3.0}) {
    BeliefScene scene;
    scene.Show(Segment(FrontalPoint(-50, 0), FrontalPoint(50, 0)), 3);
    scene.Draw({FrontalPoint(-50, 0), FrontalPoint(50, 0)}, sigma_px);
    EXPECT_EQ(DoubtsOf(scene), (Doubts{sigma_px < 1 ? LinkDoubt::kNone : LinkDoubt::kChance}));
  }
}

// A line at the same pixels of all views lies at the same place in space for the four views of a
// row.
TEST(JudgeLinksTest, WhatStandsStillMustBeSure) {
  for (const bool is_still : {false, true}) {
    for (const double sigma_px : {3.0, 0.4}) {
      BeliefScene scene;
      const Eigen::Vector3d first = scene.views[0].CenterInWorld();
      for (size_t v = 0; v < scene.views.size(); ++v) {
        const double y = scene.views[v].CenterInWorld().y() - first.y();
        if (y != 0 && !is_still) continue;
        const Eigen::Vector3d along_y(0, y, 0);
        scene.shown[v].push_back(
            Segment(along_y + FrontalPoint(-90, 30), along_y + FrontalPoint(90, 30)));
      }
      scene.Draw({FrontalPoint(-40, 30), FrontalPoint(40, 30)}, sigma_px);
      const bool is_doubted = is_still && sigma_px > 1;
      EXPECT_EQ(DoubtsOf(scene), (Doubts{is_doubted ? LinkDoubt::kStill : LinkDoubt::kNone}));
    }
  }
}

TEST(JudgeLinksTest, NeighborsAreEvidence) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0), 2);
  scene.Add(FrontalPoint(-50, 0), FrontalPoint(-50, 60));
  EXPECT_EQ(DoubtsOf(scene), (Doubts{LinkDoubt::kNone, LinkDoubt::kNone}));
}

TEST(JudgeLinksTest, WhatHasGrownFromALinkIsNoEvidenceForIt) {
  for (const bool has_grown : {true, false}) {
    BeliefScene scene;
    scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0), 2);
    scene.Add(FrontalPoint(-50, 0), FrontalPoint(-50, 20), 1);
    if (has_grown) scene.graph.links[1].members.clear();
    EXPECT_EQ(DoubtsOf(scene)[0], has_grown ? LinkDoubt::kChance : LinkDoubt::kNone);
  }
}

double EvidenceIn(const BeliefScene& scene, size_t link) {
  return Judged(scene).graph.links[link].evidence.value();
}

TEST(JudgeLinksTest, EvidenceGrowsWithTheViewsAndTheSigma) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0), 4);
  scene.Add(FrontalPoint(-50, 40), FrontalPoint(50, 40));
  EXPECT_GT(EvidenceIn(scene, 1), EvidenceIn(scene, 0));
  BeliefScene sharper = scene;
  for (double& sigma : sharper.graph.links[0].sigma) sigma /= 2;
  EXPECT_NEAR(EvidenceIn(sharper, 0), EvidenceIn(scene, 0) + 2 * std::log(2.0), 1e-6);
}

TEST(JudgeLinksTest, UnknownSigmasLeaveEvidenceFinite) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0));
  const double known = EvidenceIn(scene, 0);
  scene.graph.links[0].sigma.assign(scene.graph.links[0].sigma.size(), INFINITY);
  EXPECT_LT(EvidenceIn(scene, 0), known - 10);
  EXPECT_TRUE(std::isfinite(EvidenceIn(scene, 0)));
}

TEST(JudgeLinksTest, WithoutAJudgeThereIsNoEvidence) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0));
  scene.graph.links[0].evidence = 3;
  BeliefOptions options;
  options.judge = false;
  EXPECT_FALSE(Judged(scene, {}, options).graph.links[0].evidence);
}

// A glossy front shows the image of an edge before it to the few views that it reflects into.
TEST(JudgeLinksTest, AMirrorImageThatFewViewsShow) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-60, 60), FrontalPoint(60, 60));
  scene.Add(FrontalPoint(-60, -60), FrontalPoint(60, -60));
  const Eigen::Vector3d behind(0, 0, -0.5);
  scene.Add(FrontalPoint(-40, 0) + behind, FrontalPoint(40, 0) + behind, 2);
  EXPECT_EQ(DoubtsOf(scene), (Doubts{LinkDoubt::kNone, LinkDoubt::kNone, LinkDoubt::kChance}));
}

// Two equal edges side by side make a third one above, which half of the views see before the one,
// half before the other.
TEST(JudgeLinksTest, AGhostOfRepeatedEdges) {
  BeliefScene scene;
  // Views at x = -0.45, -0.15, 0.15, 0.45; from the outer ones a place at height z above 0 is
  // before +-0.45 z / (5 - z), the edges.
  constexpr double kHeight = 1;
  constexpr double kAt = 0.45 * kHeight / (5 - kHeight);
  for (const double x : {-kAt, kAt}) scene.Add({x, -0.6, 0}, {x, 0.6, 0});
  scene.Draw({{0, -0.3, kHeight}, {0, 0.3, kHeight}});
  ASSERT_EQ(scene.Evidence()[2].showing_views, 8);
  EXPECT_EQ(DoubtsOf(scene), (Doubts{LinkDoubt::kNone, LinkDoubt::kNone, LinkDoubt::kExplained}));
}

TEST(JudgeLinksTest, ALinkThatOthersAreSeenThrough) {
  BeliefScene scene;
  const Eigen::Vector3d up(0, 0, 1);
  scene.Add(FrontalPoint(-60, 0), FrontalPoint(60, 0));
  // The false link is between two true ones, so chance is no reason.
  const Eigen::Vector3d from = FrontalPoint(0, -40) + up;
  const Eigen::Vector3d to = FrontalPoint(0, 40) + up;
  scene.Draw({from, to});
  for (const Eigen::Vector3d& end : {from, to}) scene.Add(end, end + FrontalPoint(30, 0));
  EXPECT_EQ(DoubtsOf(scene), (Doubts{LinkDoubt::kNone, LinkDoubt::kSeenThrough, LinkDoubt::kNone,
                                     LinkDoubt::kNone}));
}

TEST(JudgeLinksTest, FewViewsDoNotContradictMany) {
  // The nearer link is hard to see around the crossing in the last views.
  const auto doubts = [](size_t num_clear) {
    BeliefScene scene;
    const Eigen::Vector3d up(0, 0, 1);
    scene.Add(FrontalPoint(-60, 0), FrontalPoint(60, 0));
    const auto at = [&](double y) { return Eigen::Vector3d(FrontalPoint(0, y) + up); };
    scene.Draw({at(-60), at(60)});
    for (size_t v = 0; v < scene.views.size(); ++v) {
      const std::vector<double> ends =
          v < num_clear ? std::vector<double>{-60, 60} : std::vector<double>{-60, -35, 35, 60};
      for (size_t k = 0; k < ends.size(); k += 2) {
        scene.shown[v].push_back(Segment(at(ends[k]), at(ends[k + 1])));
      }
    }
    return DoubtsOf(scene);
  };
  EXPECT_EQ(doubts(14), (Doubts{LinkDoubt::kNone, LinkDoubt::kNone}));
  EXPECT_EQ(doubts(8), (Doubts{LinkDoubt::kNone, LinkDoubt::kSeenThrough}));
}

TEST(JudgeLinksTest, LinksThatCouldNotBeFitted) {
  BeliefScene scene;
  const auto square = [&](double x) { return std::pair{FrontalPoint(x, 0), FrontalPoint(x, 40)}; };
  // Two edges, joined by a short link below, a long one in the middle that no view shows, a long
  // one above that many views show; and a link with a free end.
  scene.Add(square(-60).first, square(-60).second);
  scene.Add(square(60).first, square(60).second);
  scene.Add(square(60).first, FrontalPoint(80, 0));
  scene.Add(square(-60).second, square(60).second);
  scene.Draw({square(-60).first, square(60).first});
  scene.Add(FrontalPoint(80, 0), FrontalPoint(80, 40));
  scene.Draw({FrontalPoint(80, 40), FrontalPoint(100, 40)});
  scene.Add(FrontalPoint(100, 40), FrontalPoint(100, 0));
  scene.Add(FrontalPoint(100, 0), FrontalPoint(100, -40));
  const std::vector<uint8_t> fitted = {1, 1, 1, 0, 0, 1, 0, 1, 0};
  EXPECT_EQ(DoubtsOf(scene, fitted),
            (Doubts{LinkDoubt::kNone, LinkDoubt::kNone, LinkDoubt::kNone, LinkDoubt::kNone,
                    LinkDoubt::kFewViews, LinkDoubt::kNone, LinkDoubt::kNone, LinkDoubt::kNone,
                    LinkDoubt::kFewViews}));
}

TEST(JudgeLinksTest, EarlierMarksAreReplaced) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0));
  scene.graph.links[0].tentative = true;
  scene.graph.links[0].doubt = LinkDoubt::kChance;
  EXPECT_EQ(DoubtsOf(scene), (Doubts{LinkDoubt::kNone}));
}

TEST(JudgeLinksTest, WithoutJudgmentAllStaysAsItIs) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0), 2);
  BeliefOptions options;
  options.judge = false;
  const BeliefResult result = Judged(scene, {0}, options);
  EXPECT_EQ(DoubtsOf(result.graph), (Doubts{LinkDoubt::kNone}));
  EXPECT_TRUE(result.summary.in.empty());
}

// The views form a grid of four by four, 3.4 degrees apart; the link runs along its rows.
BeliefOptions FourDegrees() {
  BeliefOptions options;
  options.min_tri_angle_deg = 4;
  return options;
}

TEST(JudgeLinksTest, ViewsNearToEachOtherDoNotMeasureDepth) {
  const auto doubt_of = [](std::vector<ViewId> supporting) {
    BeliefScene scene;
    scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0));
    scene.graph.links[0].supporting_views = std::move(supporting);
    return Judged(scene, {}, FourDegrees()).graph.links[0].doubt;
  };
  EXPECT_EQ(doubt_of({0, 4}), LinkDoubt::kDepth);
  EXPECT_EQ(doubt_of({0, 1, 2, 3}), LinkDoubt::kDepth);
  EXPECT_EQ(doubt_of({0, 8}), LinkDoubt::kNone);
}

TEST(JudgeLinksTest, ALinkHeldByItsNodesIsAsGoodAsItsNeighbors) {
  for (const ViewId last : {4, 12}) {
    BeliefScene scene;
    scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0));
    scene.graph.links[0].supporting_views = {0, last};
    scene.Add(FrontalPoint(50, 0), FrontalPoint(50, 20));
    const LinkDoubt doubt = last == 4 ? LinkDoubt::kDepth : LinkDoubt::kNone;
    EXPECT_EQ(DoubtsOf(Judged(scene, {}, FourDegrees()).graph), (Doubts{doubt, doubt}));
  }
}

TEST(JudgeLinksTest, TheSummaryAccountsForAllLinks) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0));
  scene.Add(FrontalPoint(-50, 40), FrontalPoint(0, 40), 2);
  const StageSummary summary = Judged(scene).summary;
  EXPECT_EQ(summary.in, (StageSummary::Counts{{"links", 2}, {"px of links", 150}}));
  EXPECT_EQ(summary.kept, (StageSummary::Counts{{"links", 1}, {"px of links", 100}}));
  StageSummary::Counts some;
  for (const auto& count : summary.dropped) {
    if (count.second != 0) some.push_back(count);
  }
  EXPECT_EQ(some, (StageSummary::Counts{{"tentative links: chance", 1},
                                        {"px of tentative links: chance", 50}}));
}

TEST(JudgeLinksTest, AnyNumberOfThreads) {
  BeliefScene scene;
  for (int k = 0; k < 12; ++k) {
    scene.Add(FrontalPoint(-50, 8 * k - 48), FrontalPoint(50, 8 * k - 44), k + 1);
  }
  const DrawingGraph one = Judged(scene, {}, {}, 1).graph;
  EXPECT_EQ(DoubtsOf(one), DoubtsOf(Judged(scene, {}, {}, 4).graph));
}

TEST(JudgeLinksTest, ADrawingWithoutLinks) {
  EXPECT_TRUE(Judged(BeliefScene()).graph.links.empty());
}

TEST(JudgeLinksTest, OptionsAreChecked) {
  BeliefOptions options;
  options.min_evidence = -1;
  EXPECT_THROW(Judged(BeliefScene(), {}, options), OptionError);
}

}  // namespace
}  // namespace limn
