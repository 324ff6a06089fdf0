// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/finish_links.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "limn/topology/drawing_scene.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::DrawingScene;
using testing::DrawingSceneTest;
using testing::LinkTraits;
using testing::Path;
using testing::Polar;
using testing::Ring;

class FinishLinksTest : public DrawingSceneTest {
 protected:
  DrawingGraph Finished(const TopologyOptions& options = {}) { return scene_.Finished(options); }

  const DrawingNode* NodeNear(const DrawingGraph& graph, const Vector3d& point) const {
    for (const DrawingNode& node : graph.nodes) {
      if ((scene_.Px(node.position_in_world) - point).norm() < 1e-6) return &node;
    }
    ADD_FAILURE() << "no node at " << point.transpose();
    return nullptr;
  }

  // The end of the link that leaves in this direction.
  LinkEnd Leaving(const DrawingGraph& graph, const DrawingNode& node, const Vector3d& way) const {
    for (const LinkEnd& end : node.incident) {
      const auto& points = graph.links[end.link].points_in_world;
      const Vector3d step = end.end == 0 ? Vector3d(points[1] - points[0])
                                         : Vector3d(points[points.size() - 2] - points.back());
      if (step.normalized().dot(way.normalized()) > 0.999) return end;
    }
    ADD_FAILURE() << "nothing leaves to " << way.transpose();
    return {};
  }

  static bool Continue(const DrawingNode& node, const LinkEnd& a, const LinkEnd& b) {
    return std::count(node.continuations.begin(), node.continuations.end(), std::pair(a, b)) +
               std::count(node.continuations.begin(), node.continuations.end(), std::pair(b, a)) ==
           1;
  }

  // A star of links that leave the origin at these angles.
  void AddStar(const std::vector<double>& angles) {
    for (const double angle : angles) scene_.AddLink(Path({{0, 0, 0}, Polar(40, angle)}));
    scene_.ShareNode({0, 0, 0});
  }
};

TEST_P(FinishLinksTest, NothingStaysNothing) {
  const DrawingGraph graph = Finished();
  EXPECT_TRUE(graph.nodes.empty());
  EXPECT_TRUE(graph.links.empty());
}

TEST_P(FinishLinksTest, VerticesAreDropped) {
  scene_.AddLink(Path({{-20, 0, 0}, {20, 0, 0}}));
  const DrawingLink link = Finished().links.at(0);
  EXPECT_TRUE(link.vertices.empty());
  EXPECT_EQ(link.points_in_world.size(), 41u);
  EXPECT_EQ(link.sigma.size(), 41u);
}

TEST_P(FinishLinksTest, LoopsStayClosed) {
  scene_.AddLink(Ring({0, 0, 0}, 30), {.closed = true});
  const DrawingGraph graph = Finished();
  ASSERT_EQ(graph.links.size(), 1u);
  ASSERT_EQ(graph.nodes.size(), 1u);
  EXPECT_TRUE(graph.links[0].closed);
  EXPECT_EQ(graph.nodes[0].kind, NodeKind::kLoopAnchor);
  const auto& points = graph.links[0].points_in_world;
  EXPECT_EQ(points.size(), Ring({0, 0, 0}, 30).size() + 1);
  EXPECT_EQ(points.front(), points.back());
}

TEST_P(FinishLinksTest, PointsTooNearToEachOtherAreThinned) {
  Polyline3d points = Path({{-20, 0, 0}, {20, 0, 0}});
  points.insert(points.begin() + 11, Vector3d(-9.6, 0, 0));
  points.insert(points.end() - 1, Vector3d(19.7, 0, 0));
  scene_.AddLink(points);
  const DrawingGraph graph = Finished();
  const auto& kept = graph.links[0].points_in_world;
  EXPECT_EQ(kept.size(), 41u);
  for (size_t i = 1; i < kept.size(); ++i) {
    EXPECT_GE(scene_.Px(kept[i] - kept[i - 1]).norm(), 0.5) << i;
  }
}

TEST_P(FinishLinksTest, ViewsSupportALinkByThreePoints) {
  const auto points_of_view = [](int point, ViewId view) {
    if (view == 2) return point < 2;
    if (view == 5) return point == 3 || point == 17 || point == 30;
    return view != 7;
  };
  scene_.AddLink(Path({{-20, 0, 0}, {20, 0, 0}}), {.supported = points_of_view});
  EXPECT_EQ(Finished().links[0].supporting_views, (std::vector<ViewId>{0, 1, 3, 4, 5, 6}));
}

TEST_P(FinishLinksTest, ResidualIsTheDistanceFromTheEdges) {
  const int edge = scene_.AddImageCurve(Path({{-20, 0, 0}, {20, 0, 0}}));
  scene_.AddLink(Path({{-20, 0.5, 0}, {20, 0.5, 0}}), {.image_curve = edge});
  scene_.AddLink(Path({{-20, 0, 0}, {20, 0, 0}}), {.image_curve = edge});
  const DrawingGraph graph = Finished();
  // A px is .96 to 1 px across the views, and up to 1 % more or less where the link is nearer.
  EXPECT_GT(graph.links[0].residual_px, 0.5 * 0.95);
  EXPECT_LT(graph.links[0].residual_px, 0.5 * 1.01);
  EXPECT_LT(graph.links[1].residual_px, 1e-3);
}

TEST_P(FinishLinksTest, LinkThatGoesOnThroughAJunctionIsPaired) {
  AddStar({180, 0, 90});
  const DrawingGraph graph = Finished();
  const DrawingNode* node = NodeNear(graph, {0, 0, 0});
  ASSERT_TRUE(node);
  ASSERT_EQ(node->continuations.size(), 1u);
  EXPECT_TRUE(Continue(*node, Leaving(graph, *node, {1, 0, 0}), Leaving(graph, *node, {-1, 0, 0})));
}

TEST_P(FinishLinksTest, CrossHasTwoPairs) {
  AddStar({0, 90, 180, 270});
  const DrawingGraph graph = Finished();
  const DrawingNode* node = NodeNear(graph, {0, 0, 0});
  ASSERT_TRUE(node);
  ASSERT_EQ(node->continuations.size(), 2u);
  EXPECT_TRUE(Continue(*node, Leaving(graph, *node, {1, 0, 0}), Leaving(graph, *node, {-1, 0, 0})));
  EXPECT_TRUE(Continue(*node, Leaving(graph, *node, {0, 1, 0}), Leaving(graph, *node, {0, -1, 0})));
}

TEST_P(FinishLinksTest, SmoothestPairIsTaken) {
  AddStar({20, 180, -2});
  const DrawingGraph graph = Finished();
  const DrawingNode* node = NodeNear(graph, {0, 0, 0});
  ASSERT_TRUE(node);
  ASSERT_EQ(node->continuations.size(), 1u);
  EXPECT_TRUE(
      Continue(*node, Leaving(graph, *node, Polar(1, -2)), Leaving(graph, *node, {-1, 0, 0})));
}

TEST_P(FinishLinksTest, SharpTurnIsNoContinuation) {
  AddStar({180, 32});
  for (const auto& [limit_deg, pairs] : {std::pair(30.0, 0u), std::pair(34.0, 1u)}) {
    const DrawingGraph graph = Finished({.max_continuation_angle_deg = limit_deg});
    const DrawingNode* node = NodeNear(graph, {0, 0, 0});
    ASSERT_TRUE(node);
    EXPECT_EQ(node->continuations.size(), pairs);
  }
}

LIMN_ALL_VARIANTS(FinishLinksTest);

using Member = std::tuple<int, int, int>;

std::vector<Member> Members(const DrawingLink& link) {
  std::vector<Member> members;
  for (const LinkMember& run : link.members) members.push_back({run.curve, run.begin, run.end});
  return members;
}

TEST(LinkMembersTest, RunsOfSamplesOfTheSketch) {
  DrawingScene scene;
  // The curve's first 7 samples were lost before, and three amidst.
  scene.AddLink(
      Path({{-20, 0, 0}, {20, 0, 0}}),
      {.sampled = [](int point) { return point < 10 || point > 12; }, .first_sketch_sample = 7});
  scene.AddLink(Path({{-20, 20, 0}, {20, 20, 0}}));
  const DrawingGraph graph = scene.Finished();
  EXPECT_EQ(Members(graph.links[0]), (std::vector<Member>{{0, 7, 17}, {0, 20, 48}}));
  EXPECT_EQ(Members(graph.links[1]), (std::vector<Member>{{1, 0, 41}}));
}

TEST(LinkMembersTest, GrownSamplesAreNotOfTheSketch) {
  DrawingScene scene;
  scene.AddLink(Path({{-20, 0, 0}, {20, 0, 0}}), {.grown = true});
  EXPECT_TRUE(scene.Finished().links[0].members.empty());
}

TEST(LinkMembersTest, FusedLinkHasTheMembersOfBoth) {
  DrawingScene scene;
  scene.AddLink(Path({{-20, 0, 0}, {0, 0, 0}}));
  scene.AddLink(Path({{0, 0, 0}, {20, 0, 0}}));
  scene.ShareNode({0, 0, 0});
  scene.Tidy();
  const DrawingGraph graph = scene.Finished();
  ASSERT_EQ(graph.links.size(), 1u);
  EXPECT_EQ(Members(graph.links[0]), (std::vector<Member>{{0, 0, 21}, {1, 0, 21}}));
}

}  // namespace
}  // namespace limn
