#include "limn/model/graph_edits.h"

#include <numeric>

#include <gtest/gtest.h>

#include "limn/model/graph_fixture.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::ContinuationsAt;
using testing::DegreeAt;
using testing::ExpectValid;
using testing::GraphOf;
using testing::NodeAtPlace;
using Pairs = std::set<std::pair<LinkEnd, LinkEnd>>;

// Points of the x axis at steps of 1, in either direction.
Polyline3d Row(int from, int to) {
  Polyline3d points;
  const int step = from < to ? 1 : -1;
  for (int x = from; x != to + step; x += step) points.emplace_back(x, 0, 0);
  return points;
}

Polyline3d Reversed(Polyline3d points) {
  std::reverse(points.begin(), points.end());
  return points;
}

// A square with corners 1 apart that begins and ends at the origin.
Polyline3d Square() { return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}}; }

DrawingLink LinkOf(const Polyline3d& points) { return GraphOf({points}).links[0]; }

// What an edit leaves behind: nodes without links go.
void Finish(DrawingGraph* graph) {
  RemoveLinks(std::vector<uint8_t>(graph->links.size(), 1), graph);
  ExpectValid(*graph);
}

TEST(TipOfTest, StraightLinkLeavesAlongItselfAtItsEnds) {
  const DrawingLink link = LinkOf(Row(0, 30));
  const LinkTip first = TipOf(link, 0, 1);
  EXPECT_LT((first.point - Vector3d(0, 0, 0)).norm(), 1e-9);
  EXPECT_LT((first.outward - Vector3d(-1, 0, 0)).norm(), 1e-9);
  const LinkTip last = TipOf(link, 1, 1);
  EXPECT_LT((last.point - Vector3d(30, 0, 0)).norm(), 1e-9);
  EXPECT_LT((last.outward - Vector3d(1, 0, 0)).norm(), 1e-9);
}

TEST(TipOfTest, OutermostPixelsAreLeftOut) {
  Polyline3d hooked = Row(0, 30);
  hooked.emplace_back(30, 1, 0);
  const LinkTip tip = TipOf(LinkOf(hooked), 1, 1);
  EXPECT_LT((tip.outward - Vector3d(1, 0, 0)).norm(), 1e-9);
  EXPECT_LT((tip.point - Vector3d(30, 0, 0)).norm(), 1e-9);
}

TEST(TipOfTest, WhatIsFarFromTheEndDoesNotMatter) {
  Polyline3d bent = {{0, 15, 0}};
  for (const Vector3d& point : Row(0, 15)) bent.push_back(point);
  EXPECT_LT((TipOf(LinkOf(bent), 1, 1).outward - Vector3d(1, 0, 0)).norm(), 1e-9);
  // With pixels twice as large the bend is near.
  EXPECT_GT((TipOf(LinkOf(bent), 1, 2).outward - Vector3d(1, 0, 0)).norm(), 0.1);
}

TEST(TipOfTest, ShortLinkLeavesAlongItsChordAndAPointNowhere) {
  const LinkTip tip = TipOf(LinkOf({{0, 0, 0}, {0.5, 0.5, 0}, {1, 0, 0}}), 0, 1);
  EXPECT_LT((tip.outward - Vector3d(-1, 0, 0)).norm(), 1e-9);
  DrawingLink no_extent;
  no_extent.points_in_world.assign(3, Vector3d(1, 2, 3));
  EXPECT_EQ(TipOf(no_extent, 1, 1).outward, Vector3d(0, 0, 0));
  EXPECT_EQ(TipOf(no_extent, 1, 1).point, Vector3d(1, 2, 3));
}

TEST(SplitLinkTest, OpenLinkIsCutInTwoThatShareThePoint) {
  DrawingGraph graph = GraphOf({Row(0, 5)});
  const NodeId node = SplitLink(0, 2, &graph);
  RebuildIncidence(&graph);
  ExpectValid(graph);
  ASSERT_EQ(graph.links.size(), 2u);
  EXPECT_EQ(graph.links[0].points_in_world, Row(0, 2));
  EXPECT_EQ(graph.links[1].points_in_world, Row(2, 5));
  EXPECT_EQ(graph.links[0].sigma, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(graph.links[1].sigma, (std::vector<double>{3, 4, 5, 6}));
  EXPECT_EQ(graph.nodes[node].incident, (std::vector<LinkEnd>{{0, 1}, {1, 0}}));
  EXPECT_EQ(graph.nodes[node].position_in_world, Vector3d(2, 0, 0));
  for (const DrawingLink& part : graph.links) {
    ASSERT_EQ(part.members.size(), 1u);
    EXPECT_EQ(part.members[0].end, 6);
  }
}

TEST(SplitLinkTest, FirstAndLastInnerPointLeaveOneChord) {
  for (const int index : {1, 4}) {
    DrawingGraph graph = GraphOf({Row(0, 5)});
    SplitLink(0, index, &graph);
    RebuildIncidence(&graph);
    ExpectValid(graph);
    EXPECT_EQ(graph.links[0].points_in_world, Row(0, index));
    EXPECT_EQ(graph.links[1].points_in_world, Row(index, 5));
  }
}

TEST(SplitLinkTest, ContinuationsFollowTheSecondPart) {
  // Links 0 and 1 go on in each other, and so do 2 and 0 at its other end.
  DrawingGraph graph = GraphOf({Row(0, 5), Row(5, 9), Row(-4, 0)});
  graph.nodes[NodeAtPlace(graph, {5, 0, 0})].continuations = {{{0, 1}, {1, 0}}};
  graph.nodes[NodeAtPlace(graph, {0, 0, 0})].continuations = {{{2, 1}, {0, 0}}};
  SplitLink(0, 3, &graph);
  RebuildIncidence(&graph);
  ExpectValid(graph);
  EXPECT_EQ(ContinuationsAt(graph, {5, 0, 0}), (Pairs{{{1, 0}, {3, 1}}}));
  EXPECT_EQ(ContinuationsAt(graph, {0, 0, 0}), (Pairs{{{0, 0}, {2, 1}}}));
}

TEST(SplitLinkTest, LinkThatReturnsToAJunctionKeepsItsContinuationThere) {
  DrawingGraph graph = GraphOf({{{-1, 0, 0}, {0, 0, 0}}});
  testing::DrawLink(Square(), {}, &graph);
  graph.links[1].closed = false;  // another link ends at its node
  graph.nodes[NodeAtPlace(graph, {0, 0, 0})].continuations = {{{1, 0}, {1, 1}}};
  SplitLink(1, 2, &graph);
  RebuildIncidence(&graph);
  ExpectValid(graph);
  EXPECT_EQ(ContinuationsAt(graph, {0, 0, 0}), (Pairs{{{1, 0}, {2, 1}}}));
}

TEST(SplitLinkTest, ClosedLinkBeginsAndEndsAtThePoint) {
  for (const int index : {0, 1, 2, 3, 4}) {
    DrawingGraph graph = GraphOf({Square()});
    ASSERT_TRUE(graph.links[0].closed);
    const Vector3d place = Square()[index];
    const NodeId node = SplitLink(0, index, &graph);
    EXPECT_EQ(graph.nodes[node].position_in_world, place);
    Finish(&graph);
    ASSERT_EQ(graph.links.size(), 1u);
    ASSERT_EQ(graph.nodes.size(), 1u);
    const DrawingLink& link = graph.links[0];
    EXPECT_FALSE(link.closed);
    EXPECT_EQ(link.points_in_world.size(), 5u);
    EXPECT_EQ(link.points_in_world.front(), place);
    EXPECT_EQ(link.points_in_world.back(), place);
    EXPECT_EQ(Length(link.points_in_world), 4);
    EXPECT_EQ(link.sigma.front(), link.sigma.back());
    EXPECT_EQ(graph.nodes[0].incident, (std::vector<LinkEnd>{{0, 0}, {0, 1}}));
  }
}

// A link along the x axis from 0 to 10, and a node beside which it ends: at 13, or at 7.4. Every
// case is done with either end of the link.
class EndLinkAtTest : public ::testing::TestWithParam<int> {
 protected:
  DrawingGraph Moved(const Vector3d& target) const {
    const int end = GetParam();
    DrawingGraph graph = GraphOf({end == 1 ? Row(0, 10) : Row(10, 0),
                                  {target, target + Vector3d(0, 5, 0)},
                                  {target, target + Vector3d(0, -5, 0)}});
    EndLinkAt({0, end}, NodeAtPlace(graph, target), &graph);
    EXPECT_EQ(graph.links[0].sigma.size(), graph.links[0].points_in_world.size());
    Finish(&graph);
    return graph;
  }
  // The moved link's points from its end that stayed.
  static Polyline3d Points(const DrawingGraph& graph) {
    const Polyline3d& points = graph.links[0].points_in_world;
    return GetParam() == 1 ? points : Reversed(points);
  }
};

TEST_P(EndLinkAtTest, EndIsExtendedToTheNode) {
  const DrawingGraph graph = Moved({13, 0.5, 0});
  Polyline3d expected = Row(0, 10);
  expected.emplace_back(13, 0.5, 0);
  EXPECT_EQ(Points(graph), expected);
  EXPECT_EQ(DegreeAt(graph, {13, 0.5, 0}), 3);
  EXPECT_EQ(DegreeAt(graph, {0, 0, 0}), 1);
  EXPECT_EQ(graph.nodes.size(), 4u);  // the free end's is gone
}

TEST_P(EndLinkAtTest, WhatOvershootsIsCut) {
  const DrawingGraph graph = Moved({7.4, 0, 0});
  Polyline3d expected = Row(0, 7);
  expected.emplace_back(7.4, 0, 0);
  EXPECT_EQ(Points(graph), expected);
  EXPECT_EQ(DegreeAt(graph, {7.4, 0, 0}), 3);
}

TEST_P(EndLinkAtTest, SigmasStayWithTheirPoints) {
  const DrawingGraph graph = Moved({7.4, 0, 0});
  std::vector<double> sigma = graph.links[0].sigma;
  if (GetParam() == 0) std::reverse(sigma.begin(), sigma.end());
  for (int x = 0; x <= 7; ++x) {
    EXPECT_EQ(sigma[x], GetParam() == 1 ? x + 1 : 11 - x) << "at " << x;
  }
}

INSTANTIATE_TEST_SUITE_P(Ends, EndLinkAtTest, ::testing::Values(0, 1));

// Links along the x axis from 0 to 3 and from 5 to 8, each in either direction, that become one.
// At their far ends other links go on.
class JoinEndsTest : public ::testing::TestWithParam<std::tuple<int, int>> {
 protected:
  int end_a() const { return std::get<0>(GetParam()); }
  int end_b() const { return std::get<1>(GetParam()); }

  DrawingGraph Joined() const {
    const Polyline3d near = Row(0, 3);
    const Polyline3d far = Row(5, 8);
    DrawingGraph graph = GraphOf({end_a() == 1 ? near : Reversed(near),
                                  end_b() == 0 ? far : Reversed(far),
                                  {{8, 0, 0}, {9, 0, 0}},
                                  {{8, 0, 0}, {8, 1, 0}},
                                  {{-1, 0, 0}, {0, 0, 0}}});
    graph.links[0].supporting_views = {1, 4, 6};
    graph.links[1].supporting_views = {0, 4, 9};
    graph.nodes[NodeAtPlace(graph, {8, 0, 0})].continuations = {{{1, 1 - end_b()}, {2, 0}}};
    graph.nodes[NodeAtPlace(graph, {0, 0, 0})].continuations = {{{0, 1 - end_a()}, {4, 1}}};
    JoinEnds({0, end_a()}, {1, end_b()}, &graph);
    return graph;
  }
  static void RemoveSecond(DrawingGraph* graph) {
    RemoveLinks({1, 0, 1, 1, 1}, graph);
    ExpectValid(*graph);
  }
};

TEST_P(JoinEndsTest, PointsAndSigmasAreInOrder) {
  DrawingGraph graph = Joined();
  RemoveSecond(&graph);
  Polyline3d expected = Row(0, 3);
  for (const Vector3d& point : Row(5, 8)) expected.push_back(point);
  std::vector<double> sigma = {1, 2, 3, 4};
  if (end_a() == 0) sigma = {4, 3, 2, 1};
  for (int k = 0; k < 4; ++k) sigma.push_back(end_b() == 0 ? k + 1 : 4 - k);
  if (end_a() == 0) {
    std::reverse(expected.begin(), expected.end());
    std::reverse(sigma.begin(), sigma.end());
  }
  EXPECT_EQ(graph.links[0].points_in_world, expected);
  EXPECT_EQ(graph.links[0].sigma, sigma);
}

TEST_P(JoinEndsTest, FarNodesAndContinuationsStay) {
  DrawingGraph graph = Joined();
  RemoveSecond(&graph);
  EXPECT_EQ(DegreeAt(graph, {3, 0, 0}), 0);
  EXPECT_EQ(DegreeAt(graph, {5, 0, 0}), 0);
  EXPECT_EQ(DegreeAt(graph, {8, 0, 0}), 3);
  EXPECT_EQ(DegreeAt(graph, {0, 0, 0}), 2);
  const LinkEnd next{1, 0};    // link 2, before link 1 went
  const LinkEnd before{3, 1};  // link 4
  EXPECT_EQ(ContinuationsAt(graph, {8, 0, 0}), (Pairs{std::minmax(LinkEnd{0, end_a()}, next)}));
  EXPECT_EQ(ContinuationsAt(graph, {0, 0, 0}),
            (Pairs{std::minmax(LinkEnd{0, 1 - end_a()}, before)}));
}

TEST_P(JoinEndsTest, WhatIsKnownOfBothIsKept) {
  const DrawingGraph graph = Joined();
  EXPECT_EQ(graph.links[0].supporting_views, (std::vector<ViewId>{0, 1, 4, 6, 9}));
  ASSERT_EQ(graph.links[0].members.size(), 2u);
  EXPECT_EQ(graph.links[0].members[0].curve + graph.links[0].members[1].curve, 1);
  EXPECT_EQ(graph.links[0].residual_px, 0.2);
  EXPECT_FALSE(graph.links[0].closed);
}

TEST_P(JoinEndsTest, EndsAreFollowed) {
  EndMoves moves;
  moves.Joined({0, end_a()}, {1, end_b()});
  EXPECT_EQ(moves.Now({1, 1 - end_b()}), (LinkEnd{0, end_a()}));
  EXPECT_EQ(moves.Now({0, 1 - end_a()}), (LinkEnd{0, 1 - end_a()}));
  EXPECT_EQ(moves.Now({2, 0}), (LinkEnd{2, 0}));
}

INSTANTIATE_TEST_SUITE_P(Ends, JoinEndsTest,
                         ::testing::Combine(::testing::Values(0, 1), ::testing::Values(0, 1)));

TEST(JoinEndsOfOneLinkTest, LoopCloses) {
  for (const int end : {0, 1}) {
    DrawingGraph graph = GraphOf({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
    JoinEnds({0, end}, {0, 1 - end}, &graph);
    Finish(&graph);
    ASSERT_EQ(graph.nodes.size(), 1u);
    EXPECT_EQ(graph.nodes[0].kind, NodeKind::kLoopAnchor);
    EXPECT_EQ(testing::Continuations(graph.nodes[0]), (Pairs{{{0, 0}, {0, 1}}}));
    EXPECT_TRUE(graph.links[0].closed);
    EXPECT_EQ(graph.links[0].points_in_world, Square());
    EXPECT_EQ(graph.links[0].sigma, (std::vector<double>{1, 2, 3, 4, 1}));
  }
}

// Four links in a row, in mixed directions: whatever the order of the joins, it is one link.
TEST(EndMovesTest, ChainsOfJoinsEndInOneLink) {
  std::vector<int> order = {0, 1, 2};
  do {
    DrawingGraph graph = GraphOf({Row(0, 3), Row(8, 5), Row(10, 13), Row(18, 15)});
    const std::pair<LinkEnd, LinkEnd> gaps[] = {
        {{0, 1}, {1, 1}}, {{1, 0}, {2, 0}}, {{3, 1}, {2, 1}}};
    std::vector<uint8_t> keep(4, 1);
    EndMoves moves;
    for (const int gap : order) {
      const LinkEnd a = moves.Now(gaps[gap].first);
      const LinkEnd b = moves.Now(gaps[gap].second);
      ASSERT_NE(a.link, b.link);
      ASSERT_TRUE(keep[a.link] && keep[b.link]);
      JoinEnds(a, b, &graph);
      keep[b.link] = 0;
      moves.Joined(a, b);
    }
    RemoveLinks(keep, &graph);
    ExpectValid(graph);
    ASSERT_EQ(graph.links.size(), 1u);
    EXPECT_EQ(Length(graph.links[0].points_in_world), 18);
    EXPECT_EQ(graph.links[0].members.size(), 4u);
    EXPECT_EQ(DegreeAt(graph, {0, 0, 0}), 1);
    EXPECT_EQ(DegreeAt(graph, {18, 0, 0}), 1);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(RemoveLinksTest, OthersKeepTheirOrderAndContinuations) {
  // A cross of four links at the origin: 0 goes on in 2, and 1 in 3.
  DrawingGraph graph = GraphOf({{{-1, 0, 0}, {0, 0, 0}},
                                {{0, -1, 0}, {0, 0, 0}},
                                {{0, 0, 0}, {1, 0, 0}},
                                {{0, 0, 0}, {0, 1, 0}},
                                {{5, 0, 0}, {6, 0, 0}}});
  graph.nodes[NodeAtPlace(graph, {0, 0, 0})].continuations = {{{0, 1}, {2, 0}}, {{1, 1}, {3, 0}}};
  RemoveLinks({0, 1, 1, 1, 0}, &graph);
  ExpectValid(graph);
  ASSERT_EQ(graph.links.size(), 3u);
  EXPECT_EQ(graph.links[0].points_in_world.front(), Vector3d(0, -1, 0));
  EXPECT_EQ(graph.links[2].points_in_world.back(), Vector3d(0, 1, 0));
  EXPECT_EQ(graph.nodes.size(), 4u);
  EXPECT_EQ(DegreeAt(graph, {0, 0, 0}), 3);
  EXPECT_EQ(ContinuationsAt(graph, {0, 0, 0}), (Pairs{{{0, 1}, {2, 0}}}));
}

TEST(RemoveLinksTest, NothingMayRemain) {
  DrawingGraph graph = GraphOf({Row(0, 3), Square()});
  RemoveLinks({0, 0}, &graph);
  EXPECT_TRUE(graph.links.empty());
  EXPECT_TRUE(graph.nodes.empty());
}

}  // namespace
}  // namespace limn
