// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/edit_topology.h"

#include <algorithm>
#include <optional>

#include <gtest/gtest.h>

#include "limn/topology/frontal_scene.h"

namespace limn {
namespace {

using testing::FrontalScene;

TEST(RepairTopologyTest, EndThatRunsAlongAnotherLinkIsCutBack) {
  // The second link comes from the side and then runs half a pixel beside the first.
  FrontalScene scene;
  scene.ShowAndDraw({{-60, 0}, {60, 0}});
  scene.ShowAndDraw({{-12, 40}, {12, 0.5}, {36, 0.5}});
  const RepairCounts counts = scene.Repair();
  EXPECT_EQ(counts.trimmed, 1);
  // What is left of it meets the first one.
  EXPECT_EQ(counts.meetings.to_links, 1);
  ASSERT_EQ(scene.graph.links.size(), 3u);
  for (const Eigen::Vector3d& point : scene.graph.links[1].points_in_world) {
    EXPECT_LT(point.x() / testing::kFrontalPx, 14);
  }
}

TEST(RepairTopologyTest, LinkOfWhichLittleRemainsGoes) {
  FrontalScene scene;
  scene.ShowAndDraw({{-60, 0}, {60, 0}});
  scene.Draw({{0, 0.5}, {25, 0.5}});
  EXPECT_EQ(scene.Repair().trimmed, 1);
  EXPECT_EQ(scene.graph.links.size(), 1u);
  EXPECT_EQ(scene.graph.nodes.size(), 2u);
}

TEST(RepairTopologyTest, EndsThatFaceEachOtherAreJoinedWhereImagesShowIt) {
  const auto joined = [](double shown_to_px) {
    FrontalScene scene;
    scene.Draw({{-60, 0}, {-4, 0}});
    scene.Draw({{60, 0}, {4, 0}});
    scene.Show({{-60, 0}, {-shown_to_px, 0}});
    scene.Show({{60, 0}, {shown_to_px, 0}});
    const RepairCounts counts = scene.Repair();
    EXPECT_EQ(scene.graph.links.size(), counts.meetings.joined == 1 ? 1u : 2u);
    EXPECT_EQ(counts.meetings.refused > 0, counts.meetings.joined == 0);
    return counts.meetings.joined;
  };
  EXPECT_EQ(joined(1), 1);
  EXPECT_EQ(joined(9), 0);
}

TEST(RepairTopologyTest, ChainOfThreeIsOneLink) {
  FrontalScene scene;
  scene.Draw({{-60, 0}, {-24, 0}});
  scene.Draw({{24, 0}, {-22.8, 0}});
  scene.Draw({{25.2, 0}, {60, 0}});
  EXPECT_EQ(scene.Repair().meetings.joined, 2);
  ASSERT_EQ(scene.graph.links.size(), 1u);
  EXPECT_NEAR(scene.TotalPx(), 120, 1e-6);
}

TEST(RepairTopologyTest, OpenRingIsClosed) {
  FrontalScene scene;
  scene.Draw(testing::ArcFromOrigin(40, 2 * M_PI - 2.0 / 40));
  EXPECT_EQ(scene.Repair().meetings.joined, 1);
  ASSERT_EQ(scene.graph.links.size(), 1u);
  EXPECT_TRUE(scene.graph.links[0].closed);
  EXPECT_EQ(scene.graph.nodes.size(), 1u);
}

TEST(RepairTopologyTest, EndNearTheInsideOfALinkMakesATJunction) {
  FrontalScene scene;
  scene.ShowAndDraw({{-60, 0}, {60, 0}});
  scene.Show({{12, 60}, {12, 0}});
  scene.Draw({{12, 50}, {12, 6}});
  EXPECT_EQ(scene.Repair().meetings.to_links, 1);
  ASSERT_EQ(scene.graph.links.size(), 3u);
  ASSERT_EQ(scene.graph.nodes.size(), 4u);
  EXPECT_EQ(scene.Node(12, 0).kind, NodeKind::kJunction);
  // The cut link continues in its other part, the new one does not.
  EXPECT_EQ(testing::Continuations(scene.Node(12, 0)),
            (std::set<std::pair<LinkEnd, LinkEnd>>{{{0, 1}, {2, 0}}}));
}

TEST(RepairTopologyTest, EndNearANodeEndsThere) {
  FrontalScene scene;
  scene.Draw({{-60, 0}, {0, 0}});
  scene.Draw({{0, 50}, {0, 1.2}});
  EXPECT_EQ(scene.Repair().meetings.to_nodes, 1);
  EXPECT_EQ(scene.graph.nodes.size(), 3u);
}

TEST(RepairTopologyTest, LinksAreCutAtCornersButNotOnArcs) {
  FrontalScene scene;
  scene.Draw({{-50, -20}, {0, -20}, {0, -70}});
  scene.Draw(testing::ArcFromOrigin(12, M_PI));
  EXPECT_EQ(scene.Repair().splits, 1);
  ASSERT_EQ(scene.graph.links.size(), 3u);
  EXPECT_EQ(scene.Degree(0, -20), 2);
  EXPECT_TRUE(scene.Node(0, -20).continuations.empty());
}

TEST(RepairTopologyTest, EdgesGrowBetweenNodesOnly) {
  // Too short for a long edge.
  FrontalScene scene;
  scene.ShowAndDraw({{-60, 0}, {0, 0}});
  scene.ShowAndDraw({{0, 15}, {60, 15}});
  scene.Show({{0, 0}, {0, 15}});
  scene.Show({{-60, 0}, {-60, -40}});  // leads nowhere
  EXPECT_EQ(scene.Repair().grown, 1);
  ASSERT_EQ(scene.graph.links.size(), 3u);
  EXPECT_EQ(scene.Degree(0, 0), 2);
  EXPECT_EQ(scene.Degree(0, 15), 2);
  // The next fit looks for the edge in these views.
  EXPECT_EQ(scene.graph.links[2].supporting_views.size(), scene.views().size());
}

TEST(RepairTopologyTest, NodesOfOneCurveAreDissolved) {
  FrontalScene scene;
  scene.Draw({{-60, 0}, {0, 0}});
  scene.Draw({{0, 0}, {60, 0}});
  EXPECT_EQ(scene.Repair().dissolved_nodes, 1);
  EXPECT_EQ(scene.graph.links.size(), 1u);
}

TEST(RepairTopologyTest, ReachIsThatOfFittedLinks) {
  // Drawn links may miss each other by more.
  FrontalScene scene;
  scene.Draw({{-60, 0}, {0, 0}});
  scene.Draw({{2, 2}, {60, 2}});
  EXPECT_EQ(scene.Repair().meetings.joined, 0);
}

TEST(RepairTopologyTest, NothingIsDoneToNothing) {
  FrontalScene none;
  const RepairCounts counts = none.Repair();
  EXPECT_EQ(counts.trimmed + counts.splits + counts.meetings.joined, 0);
}

TEST(RepairTopologyTest, LinksWithoutVerticesStayAsTheyAre) {
  FrontalScene scene;
  scene.Draw({{-60, 0}, {60, 0}});
  scene.Draw({{0, 0.5}, {25, 0.5}});
  scene.Draw({{61, 0}, {90, 0}, {90, 40}});
  scene.graph.nodes[scene.graph.links[2].node0].continuations = {};
  for (const LinkId id : {0, 1, 2}) scene.Freeze(id);
  const DrawingGraph before = scene.graph;
  const RepairCounts counts = scene.Repair();
  EXPECT_EQ(counts.trimmed + counts.splits + counts.meetings.joined, 0);
  EXPECT_EQ(counts.meetings.to_nodes + counts.meetings.to_links, 0);
  ASSERT_EQ(scene.graph.links.size(), 3u);
  for (const LinkId id : {0, 1, 2}) {
    EXPECT_EQ(scene.graph.links[id].points_in_world, before.links[id].points_in_world);
  }
}

TEST(RepairTopologyTest, ContinuationsAmongLinksWithoutVerticesStay) {
  FrontalScene scene;
  scene.Draw({{-60, 0}, {0, 0}});
  scene.Draw({{0, 0}, {0, 60}});
  const auto pairs = std::set<std::pair<LinkEnd, LinkEnd>>{{{0, 1}, {1, 0}}};
  scene.graph.nodes[scene.graph.links[0].node1].continuations = {{{0, 1}, {1, 0}}};
  scene.Freeze(0);
  scene.Freeze(1);
  scene.Repair();
  EXPECT_EQ(testing::Continuations(scene.Node(0, 0)), pairs);
}

// Three edges of which each ends before the corner, and what else was drawn of them.
class CompleteDrawingTest : public ::testing::Test {
 protected:
  CompletionCounts Complete() {
    scene_.Build();
    // A curve of the sketch per link, made by two primary views that agree.
    for (DrawingLink& link : scene_.graph.links) {
      sketch_.curves.emplace_back();
      Curve3D& curve = sketch_.curves.back();
      curve.points_in_world = link.points_in_world;
      curve.anchor.view = 0;
      for (LinkVertex& vertex : link.vertices) vertex.agreeing_views = agreeing_;
    }
    // Another that was merged into all of them.
    sketch_.curves.emplace_back();
    sketch_.curves.back().anchor.view = 1;
    for (DrawingLink& link : scene_.graph.links) {
      const int sample = static_cast<int>(sketch_.curves.back().points_in_world.size());
      sketch_.curves.back().points_in_world.push_back(link.points_in_world[1]);
      link.vertices[1].samples.push_back({static_cast<int>(sketch_.curves.size()) - 1, sample});
    }
    for (const Curve3D& curve : sketch_.curves) {
      fates_.emplace_back(curve.points_in_world.size(), EdgelFate::kDrawn);
    }
    const CompletionCounts counts =
        CompleteDrawing(scene_.Input(), sketch_, scene_.options, {}, &scene_.graph, &fates_);
    testing::ExpectValid(scene_.graph);
    return counts;
  }

  int64_t NumFates(EdgelFate fate) const {
    int64_t count = 0;
    for (const auto& of_curve : fates_) count += std::count(of_curve.begin(), of_curve.end(), fate);
    return count;
  }

  FrontalScene scene_;
  CurveSketch sketch_;
  SampleFates fates_;
  int agreeing_ = 4;
};

TEST_F(CompleteDrawingTest, EdgesMeetAndWhatIsMissingGrows) {
  for (const double angle : {0.0, 2.0}) {
    scene_.Show(testing::Ray({0, 0}, angle, 60));
    scene_.Draw(testing::Ray(5 * testing::Unit(angle), angle, 55));
  }
  scene_.Show(testing::Ray({0, 0}, 4.0, 40));  // nothing of it was drawn
  const CompletionCounts counts = Complete();
  EXPECT_EQ(counts.meetings.corners, 1);
  EXPECT_EQ(counts.grown, 1);
  EXPECT_EQ(counts.samples_doubtful, 0);
  EXPECT_EQ(scene_.graph.links.size(), 3u);
  EXPECT_EQ(scene_.Degree(0, 0, 0.5), 3);
  for (const DrawingLink& link : scene_.graph.links) {
    EXPECT_TRUE(link.vertices.empty());
    EXPECT_EQ(link.supporting_views.size(), scene_.views().size());
  }
}

TEST_F(CompleteDrawingTest, EverySampleHasItsFate) {
  scene_.ShowAndDraw({{-60, 0}, {60, 0}});
  scene_.ShowAndDraw({{-60, 30}, {-50, 30}});  // too short
  const int num_long = 121 + 1;
  const int num_short = 11 + 1;
  const CompletionCounts counts = Complete();
  EXPECT_EQ(counts.tidy.samples_short, num_short);
  EXPECT_EQ(NumFates(EdgelFate::kDrawn), num_long);
  EXPECT_EQ(NumFates(EdgelFate::kPrunedLink), num_short);
  ASSERT_EQ(scene_.graph.links.size(), 1u);
  EXPECT_EQ(scene_.graph.links[0].members.size(), 2u);
}

TEST_F(CompleteDrawingTest, DoubtfulLinksGoFirst) {
  // No image shows it, and one primary view is all that agrees.
  agreeing_ = 1;
  scene_.Draw({{-60, 0}, {60, 0}});
  const CompletionCounts counts = Complete();
  EXPECT_EQ(counts.samples_doubtful, 122);
  EXPECT_EQ(NumFates(EdgelFate::kDoubtfulLink), 122);
  EXPECT_TRUE(scene_.graph.links.empty());
}

}  // namespace
}  // namespace limn
