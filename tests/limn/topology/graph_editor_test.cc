// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/graph_editor.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "limn/geometry/polyline.h"
#include "limn/topology/editor_fixture.h"
#include "limn/topology/link_geometry.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::Continuations;
using testing::ContinuationsAt;
using testing::DegreeAt;
using testing::ExpectSound;
using testing::ExpectValid;
using testing::GiveVertices;
using testing::GraphWithVertices;
using testing::NodeAtPlace;
using testing::Reversed;
using testing::Row;
using testing::Samples;
using testing::Square;
using PairsOfEnds = std::set<std::pair<LinkEnd, LinkEnd>>;

TEST(GraphEditorTest, AddMakesTheNodesThatAreNotGiven) {
  DrawingGraph graph = GraphWithVertices({Row(0, 3)});
  GraphEditor editor(&graph);
  DrawingLink link = GraphWithVertices({Row(3, 7)}).links[0];
  link.node0 = 1;
  link.node1 = -1;
  EXPECT_EQ(editor.Add(link), 1);
  ExpectSound(graph, "add");
  EXPECT_EQ(graph.nodes.size(), 3u);
  EXPECT_EQ(graph.nodes[1].incident, (std::vector<LinkEnd>{{0, 1}, {1, 0}}));
  EXPECT_EQ(DegreeAt(graph, {7, 0, 0}), 1);
}

TEST(GraphEditorTest, AddOfALineThatReturnsIsClosed) {
  DrawingGraph graph;
  GraphEditor editor(&graph);
  DrawingLink link = GraphWithVertices({Square()}).links[0];
  link.node0 = link.node1 = -1;
  link.closed = false;
  editor.Add(link);
  ExpectSound(graph, "add");
  EXPECT_TRUE(graph.links[0].closed);
  ASSERT_EQ(graph.nodes.size(), 1u);
  EXPECT_EQ(graph.nodes[0].kind, NodeKind::kLoopAnchor);
}

TEST(GraphEditorTest, LoopAtAJunctionIsNotClosedUntilItIsAlone) {
  DrawingGraph graph = GraphWithVertices({Square()});
  GraphEditor editor(&graph);
  DrawingLink link = GraphWithVertices({Row(-3, 0)}).links[0];
  link.node0 = -1;
  link.node1 = graph.links[0].node0;
  const LinkId other = editor.Add(link);
  ExpectSound(graph, "add");
  EXPECT_FALSE(graph.links[0].closed);
  EXPECT_EQ(graph.nodes[link.node1].kind, NodeKind::kJunction);
  editor.Remove(other);
  ExpectSound(graph, "remove");
  EXPECT_TRUE(graph.links[0].closed);
}

TEST(GraphEditorTest, RemoveLeavesAGapUntilCompact) {
  DrawingGraph graph = GraphWithVertices({Row(0, 3), Row(3, 6), Row(6, 9)});
  GraphEditor editor(&graph);
  editor.Remove(1);
  EXPECT_TRUE(editor.IsLink(0) && editor.IsLink(2));
  EXPECT_FALSE(editor.IsLink(1));
  EXPECT_EQ(editor.NumLinks(), 3);
  EXPECT_EQ(editor.FreeEnds(), (std::vector<LinkEnd>{{0, 0}, {0, 1}, {2, 0}, {2, 1}}));
  editor.Remove(0);
  EXPECT_FALSE(editor.IsNode(NodeAtPlace(graph, {3, 0, 0})));
  editor.Compact();
  ExpectSound(graph, "compact");
  ASSERT_EQ(graph.links.size(), 1u);
  EXPECT_EQ(graph.links[0].points_in_world, Row(6, 9));
  EXPECT_EQ(graph.nodes.size(), 2u);
}

TEST(GraphEditorTest, RemovedEndsContinueNothing) {
  DrawingGraph graph = GraphWithVertices({Row(-3, 0), Row(0, 3), {{0, 0, 0}, {0, 3, 0}}});
  graph.nodes[NodeAtPlace(graph, {0, 0, 0})].continuations = {{{0, 1}, {1, 0}}};
  GraphEditor editor(&graph);
  editor.Remove(1);
  ExpectSound(graph, "remove");
  EXPECT_TRUE(ContinuationsAt(graph, {0, 0, 0}).empty());
}

TEST(GraphEditorTest, KeepRemovesTheOthersAndKeepsTheOrder) {
  DrawingGraph graph = GraphWithVertices({Row(0, 3), Row(3, 6), Row(6, 9), Row(20, 22)});
  GraphEditor editor(&graph);
  editor.Remove(3);
  editor.Keep({1, 0, 1, 1});
  ExpectSound(graph, "keep");
  ASSERT_EQ(graph.links.size(), 2u);
  EXPECT_EQ(graph.links[0].points_in_world, Row(0, 3));
  EXPECT_EQ(graph.links[1].points_in_world, Row(6, 9));
  EXPECT_EQ(graph.nodes.size(), 4u);
}

TEST(GraphEditorTest, NodeThatNothingCameToIsGoneAfterCompact) {
  DrawingGraph graph = GraphWithVertices({Row(0, 3)});
  GraphEditor editor(&graph);
  const NodeId node = editor.AddNode({5, 5, 5});
  EXPECT_FALSE(editor.IsNode(node));
  editor.Compact();
  EXPECT_EQ(graph.nodes.size(), 2u);
  ExpectSound(graph, "compact");
}

TEST(SplitTest, OpenLinkIsCutInTwoThatShareThePoint) {
  for (const int index : {1, 2, 4}) {
    DrawingGraph graph = GraphWithVertices({Row(0, 5)});
    graph.links[0].supporting_views = {2, 5};
    GraphEditor editor(&graph);
    const NodeId node = editor.Split(0, index);
    ExpectSound(graph, "split");
    ASSERT_EQ(graph.links.size(), 2u);
    EXPECT_EQ(graph.links[0].points_in_world, Row(0, index));
    EXPECT_EQ(graph.links[1].points_in_world, Row(index, 5));
    EXPECT_EQ(graph.links[1].sigma.front(), index + 1);
    EXPECT_EQ(graph.links[1].sigma.back(), 6);
    EXPECT_EQ(graph.nodes[node].incident, (std::vector<LinkEnd>{{0, 1}, {1, 0}}));
    EXPECT_EQ(graph.nodes[node].position_in_world, Vector3d(index, 0, 0));
    for (const DrawingLink& part : graph.links) {
      EXPECT_EQ(part.members.size(), 1u);
      EXPECT_EQ(part.supporting_views, (std::vector<ViewId>{2, 5}));
    }
    // The sample of the point stays with the first part.
    EXPECT_EQ(Samples(graph.links[0]).back(), std::vector<int>{index});
    EXPECT_TRUE(graph.links[1].vertices.front().samples.empty());
    EXPECT_TRUE(graph.links[1].vertices.front().support.empty());
    EXPECT_EQ(graph.links[1].vertices.front().information(0, 0), index + 1);
  }
}

TEST(SplitTest, ContinuationsFollowTheSecondPart) {
  // Links 0 and 1 continue each other, and so do 2 and 0 at its other end.
  DrawingGraph graph = GraphWithVertices({Row(0, 5), Row(5, 9), Row(-4, 0)});
  graph.nodes[NodeAtPlace(graph, {5, 0, 0})].continuations = {{{0, 1}, {1, 0}}};
  graph.nodes[NodeAtPlace(graph, {0, 0, 0})].continuations = {{{2, 1}, {0, 0}}};
  GraphEditor(&graph).Split(0, 3);
  ExpectSound(graph, "split");
  EXPECT_EQ(ContinuationsAt(graph, {5, 0, 0}), (PairsOfEnds{{{1, 0}, {3, 1}}}));
  EXPECT_EQ(ContinuationsAt(graph, {0, 0, 0}), (PairsOfEnds{{{0, 0}, {2, 1}}}));
}

TEST(SplitTest, LinkThatReturnsToAJunctionKeepsItsContinuationThere) {
  DrawingGraph graph = GraphWithVertices({{{-1, 0, 0}, {0, 0, 0}}, Square()});
  graph.links[1].closed = false;  // another link ends at its node
  graph.nodes[NodeAtPlace(graph, {0, 0, 0})].continuations = {{{1, 0}, {1, 1}}};
  GraphEditor(&graph).Split(1, 2);
  ExpectSound(graph, "split");
  EXPECT_EQ(ContinuationsAt(graph, {0, 0, 0}), (PairsOfEnds{{{1, 0}, {2, 1}}}));
}

TEST(SplitTest, ClosedLinkBeginsAndEndsAtThePoint) {
  for (const int index : {0, 1, 2, 3, 4}) {
    DrawingGraph graph = GraphWithVertices({Square()});
    ASSERT_TRUE(graph.links[0].closed);
    const Vector3d place = Square()[index];
    const NodeId node = GraphEditor(&graph).Split(0, index);
    ExpectSound(graph, "split");
    EXPECT_EQ(graph.nodes[node].position_in_world, place);
    ASSERT_EQ(graph.links.size(), 1u);
    ASSERT_EQ(graph.nodes.size(), 1u);
    const DrawingLink& link = graph.links[0];
    EXPECT_TRUE(link.closed);  // until another end comes
    EXPECT_EQ(link.points_in_world.size(), 5u);
    EXPECT_EQ(link.points_in_world.front(), place);
    EXPECT_EQ(link.points_in_world.back(), place);
    EXPECT_EQ(Length(link.points_in_world), 4);
    EXPECT_EQ(link.sigma.front(), link.sigma.back());
    EXPECT_EQ(graph.nodes[0].incident, (std::vector<LinkEnd>{{0, 0}, {0, 1}}));
    EXPECT_EQ(Samples(link).front(), std::vector<int>{index % 4});
    EXPECT_TRUE(Samples(link).back().empty());
    EXPECT_EQ(NumSketchSamples(link), 4);
  }
}

TEST(SplitTest, EndThatComesToASplitLoopMakesAJunction) {
  DrawingGraph graph = GraphWithVertices({Square(), {{5, 1, 0}, {2, 1, 0}}});
  GraphEditor editor(&graph);
  const NodeId node = editor.Split(0, 2);
  editor.EndAt({1, 1}, node);
  ExpectSound(graph, "end at");
  EXPECT_FALSE(graph.links[0].closed);
  EXPECT_EQ(graph.nodes[node].kind, NodeKind::kJunction);
  EXPECT_EQ(graph.nodes[node].Degree(), 3);
}

TEST(MoveEndsTest, AllEndsAtANodeMove) {
  DrawingGraph graph =
      GraphWithVertices({{{0, 0, 0}, {4, 0, 0}}, {{9, 0, 0}, {5, 0, 0}}, {{4, 9, 0}, {4, 1, 0}}});
  GraphEditor editor(&graph);
  editor.EndAt({2, 1}, graph.links[0].node1);
  editor.MoveEnds(graph.links[0].node1, graph.links[1].node1);
  ExpectSound(graph, "move ends");
  EXPECT_EQ(graph.links[0].node1, graph.links[1].node1);
  EXPECT_EQ(graph.links[2].node1, graph.links[1].node1);
  EXPECT_EQ(graph.links[2].points_in_world.back(), Eigen::Vector3d(5, 0, 0));
}

TEST(FreeTest, SplitLoopHasTwoFreeEndsAtThePoint) {
  for (const int index : {0, 1, 3}) {
    DrawingGraph graph = GraphWithVertices({Square()});
    GraphEditor editor(&graph);
    editor.Split(0, index);
    editor.Free({0, 1});
    ExpectSound(graph, "open");
    const DrawingLink& link = graph.links[0];
    EXPECT_FALSE(link.closed);
    EXPECT_EQ(editor.FreeEnds(), (std::vector<LinkEnd>{{0, 0}, {0, 1}}));
    EXPECT_EQ(link.points_in_world.front(), Square()[index]);
    EXPECT_EQ(link.points_in_world.back(), Square()[index]);
    EXPECT_NE(link.node0, link.node1);
    EXPECT_EQ(NumSketchSamples(link), 4);
    EXPECT_TRUE(graph.nodes[link.node0].continuations.empty());
  }
}

// A link along the x axis from 0 to 10, and a node beside which it ends: at 13, or at 7.4. Every
// case is done with either end of the link.
class EndAtTest : public ::testing::TestWithParam<int> {
 protected:
  DrawingGraph Moved(const Vector3d& target) const {
    const int end = GetParam();
    DrawingGraph graph = GraphWithVertices({end == 1 ? Row(0, 10) : Row(10, 0),
                                            {target, target + Vector3d(0, 5, 0)},
                                            {target, target + Vector3d(0, -5, 0)}});
    GraphEditor editor(&graph);
    editor.EndAt({0, end}, NodeAtPlace(graph, target));
    ExpectSound(graph, "end at");
    EXPECT_EQ(NumSketchSamples(graph.links[0]), 11);
    editor.Compact();
    return graph;
  }
  // The moved link's points from its end that stayed.
  static Polyline3d Points(const DrawingGraph& graph) {
    const Polyline3d& points = graph.links[0].points_in_world;
    return GetParam() == 1 ? points : Reversed(points);
  }
};

TEST_P(EndAtTest, EndIsExtendedToTheNode) {
  const DrawingGraph graph = Moved({13, 0.5, 0});
  Polyline3d expected = Row(0, 10);
  expected.emplace_back(13, 0.5, 0);
  EXPECT_EQ(Points(graph), expected);
  EXPECT_EQ(DegreeAt(graph, {13, 0.5, 0}), 3);
  EXPECT_EQ(DegreeAt(graph, {0, 0, 0}), 1);
  EXPECT_EQ(graph.nodes.size(), 4u);  // the free end's is gone
  // Nothing supports the point that was added; it is as well known as the end.
  const auto& vertices = graph.links[0].vertices;
  const LinkVertex& added = GetParam() == 1 ? vertices.back() : vertices.front();
  EXPECT_TRUE(added.samples.empty() && added.support.empty());
  EXPECT_EQ(added.agreeing_views, 0);
  EXPECT_EQ(added.information(0, 0), GetParam() == 1 ? 11 : 1);
}

TEST_P(EndAtTest, WhatOvershootsIsCut) {
  const DrawingGraph graph = Moved({7.4, 0, 0});
  Polyline3d expected = Row(0, 7);
  expected.emplace_back(7.4, 0, 0);
  EXPECT_EQ(Points(graph), expected);
  EXPECT_EQ(DegreeAt(graph, {7.4, 0, 0}), 3);
}

TEST_P(EndAtTest, SamplesCutOffAreThoseOfThePointBefore) {
  const DrawingGraph graph = Moved({7.4, 0, 0});
  std::vector<std::vector<int>> samples = Samples(graph.links[0]);
  if (GetParam() == 0) std::reverse(samples.begin(), samples.end());
  ASSERT_EQ(samples.size(), 9u);
  EXPECT_TRUE(samples[8].empty());
  std::sort(samples[7].begin(), samples[7].end());
  EXPECT_EQ(samples[7],
            GetParam() == 1 ? (std::vector<int>{7, 8, 9, 10}) : (std::vector<int>{0, 1, 2, 3}));
}

TEST_P(EndAtTest, SigmasStayWithTheirPoints) {
  const DrawingGraph graph = Moved({7.4, 0, 0});
  std::vector<double> sigma = graph.links[0].sigma;
  if (GetParam() == 0) std::reverse(sigma.begin(), sigma.end());
  for (int x = 0; x <= 7; ++x) {
    EXPECT_EQ(sigma[x], GetParam() == 1 ? x + 1 : 11 - x) << "at " << x;
  }
}

TEST_P(EndAtTest, EndThatIsThereAlreadyStaysAsItIs) {
  const int end = GetParam();
  for (const int length : {1, 10}) {
    DrawingGraph graph = GraphWithVertices({end == 1 ? Row(0, length) : Row(length, 0)});
    const Polyline3d before = graph.links[0].points_in_world;
    GraphEditor editor(&graph);
    editor.EndAt({0, end}, editor.AddNode({static_cast<double>(length), 0, 0}));
    ExpectSound(graph, "end at");
    EXPECT_EQ(graph.links[0].points_in_world, before);
    EXPECT_EQ(NumSketchSamples(graph.links[0]), length + 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Ends, EndAtTest, ::testing::Values(0, 1));

TEST(EndAtOwnNodeTest, LinkThatEndsWhereItBeginsIsClosed) {
  // The last step leads a little towards the place, so that nothing overshoots it.
  DrawingGraph graph = GraphWithVertices({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.1, 0.9, 0}}});
  GraphEditor editor(&graph);
  editor.EndAt({0, 1}, graph.links[0].node0);
  ExpectSound(graph, "end at");
  EXPECT_TRUE(graph.links[0].closed);
  EXPECT_EQ(graph.links[0].points_in_world,
            (Polyline3d{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.1, 0.9, 0}, {0, 0, 0}}));
}

TEST(FreeTest, EndGetsANodeOfItsOwnAtTheSamePlace) {
  DrawingGraph graph = GraphWithVertices({Row(-3, 0), Row(0, 3), {{0, 0, 0}, {0, 3, 0}}});
  graph.nodes[NodeAtPlace(graph, {0, 0, 0})].continuations = {{{0, 1}, {1, 0}}};
  const NodeId node = NodeAtPlace(graph, {0, 0, 0});
  GraphEditor editor(&graph);
  editor.Free({1, 0});
  ExpectSound(graph, "free");
  EXPECT_TRUE(editor.IsFree({1, 0}));
  EXPECT_EQ(graph.links[1].points_in_world, Row(0, 3));
  EXPECT_EQ(graph.nodes[node].incident, (std::vector<LinkEnd>{{0, 1}, {2, 0}}));
  EXPECT_EQ(graph.nodes[node].kind, NodeKind::kEnd);
  EXPECT_TRUE(graph.nodes[node].continuations.empty());
}

TEST(CutToTest, EndsThatAreCutAreFree) {
  DrawingGraph graph = GraphWithVertices({Row(0, 9), Row(9, 12), Row(-3, 0)});
  GraphEditor editor(&graph);
  editor.CutTo(0, 0, 7);
  ExpectSound(graph, "cut");
  EXPECT_EQ(graph.links[0].points_in_world, Row(0, 6));
  EXPECT_TRUE(editor.IsFree({0, 1}));
  EXPECT_TRUE(editor.IsFree({1, 0}));
  EXPECT_FALSE(editor.IsFree({0, 0}));
  editor.CutTo(0, 2, 7);
  ExpectSound(graph, "cut");
  EXPECT_EQ(graph.links[0].points_in_world, Row(2, 6));
  EXPECT_EQ(graph.links[0].sigma, (std::vector<double>{3, 4, 5, 6, 7}));
  EXPECT_EQ(Samples(graph.links[0]), (std::vector<std::vector<int>>{{2}, {3}, {4}, {5}, {6}}));
  EXPECT_TRUE(editor.IsFree({0, 0}));
}

TEST(CutToTest, AllOfALinkIsNoCut) {
  DrawingGraph graph = GraphWithVertices({Row(10, 19), Row(19, 22), Square()});
  const LinkId loop = 2;
  GraphEditor editor(&graph);
  editor.CutTo(0, 0, 10);
  editor.CutTo(loop, 0, 5);
  ExpectSound(graph, "cut");
  EXPECT_FALSE(editor.IsFree({0, 1}));
}

TEST(CutToTest, LoopThatIsCutIsOpen) {
  DrawingGraph graph = GraphWithVertices({Square()});
  GraphEditor editor(&graph);
  editor.CutTo(0, 1, 5);
  ExpectSound(graph, "cut");
  EXPECT_FALSE(graph.links[0].closed);
  EXPECT_EQ(editor.FreeEnds(), (std::vector<LinkEnd>{{0, 0}, {0, 1}}));
  EXPECT_EQ(Length(graph.links[0].points_in_world), 3);
}

TEST(DropOvershootTest, PointsBeyondThePlaceAreCutOff) {
  for (const int end : {0, 1}) {
    DrawingGraph graph = GraphWithVertices({end == 1 ? Row(0, 9) : Row(9, 0), Row(9, 12)});
    GraphEditor editor(&graph);
    editor.DropOvershoot({0, end}, {6.5, 2, 0});
    ExpectSound(graph, "drop");
    EXPECT_EQ(graph.links[0].points_in_world, end == 1 ? Row(0, 6) : Row(6, 0));
    EXPECT_EQ(NumSketchSamples(graph.links[0]), 10);
    EXPECT_TRUE(editor.IsFree({0, end}));
    const LinkVertex& tip =
        end == 1 ? graph.links[0].vertices.back() : graph.links[0].vertices.front();
    EXPECT_EQ(tip.support.size(), 4u);
    // The most that agreed anywhere.
    EXPECT_EQ(tip.agreeing_views, end == 1 ? 9 : 3);
  }
}

TEST(DropOvershootTest, NothingIsCutOffBeforeThePlace) {
  DrawingGraph graph = GraphWithVertices({Row(0, 9), Row(9, 12)});
  GraphEditor editor(&graph);
  editor.DropOvershoot({0, 1}, {9.5, 0, 0});
  ExpectSound(graph, "drop");
  EXPECT_EQ(graph.links[0].points_in_world, Row(0, 9));
  EXPECT_FALSE(editor.IsFree({0, 1}));
}

TEST(DropOvershootTest, TwoPointsAreKept) {
  DrawingGraph graph = GraphWithVertices({Row(0, 9)});
  GraphEditor(&graph).DropOvershoot({0, 1}, {-20, 0, 0});
  ExpectSound(graph, "drop");
  EXPECT_EQ(graph.links[0].size(), 2);
  EXPECT_EQ(NumSketchSamples(graph.links[0]), 10);
}

// Links along the x axis from 0 to 3 and from 5 to 8, each in either direction, that become one.
// Other links continue at their far ends.
class JoinTest : public ::testing::TestWithParam<std::tuple<int, int>> {
 protected:
  int end_a() const { return std::get<0>(GetParam()); }
  int end_b() const { return std::get<1>(GetParam()); }

  JoinTest() : graph_(Apart()) {
    GraphEditor editor(&graph_);
    editor.Join({0, end_a()}, {1, end_b()});
    ExpectSound(graph_, "join");
    EXPECT_FALSE(editor.IsLink(1));
    EXPECT_EQ(editor.CurrentEnd({1, 1 - end_b()}), (LinkEnd{0, end_a()}));
    EXPECT_EQ(editor.CurrentEnd({0, 1 - end_a()}), (LinkEnd{0, 1 - end_a()}));
    EXPECT_EQ(editor.CurrentEnd({2, 0}), (LinkEnd{2, 0}));
    editor.Compact();
  }

  DrawingGraph Apart() const {
    const Polyline3d near = Row(0, 3);
    const Polyline3d far = Row(5, 8);
    DrawingGraph graph = GraphWithVertices({end_a() == 1 ? near : Reversed(near),
                                            end_b() == 0 ? far : Reversed(far),
                                            {{8, 0, 0}, {9, 0, 0}},
                                            {{8, 0, 0}, {8, 1, 0}},
                                            {{-1, 0, 0}, {0, 0, 0}}});
    graph.links[0].supporting_views = {1, 4, 6};
    graph.links[1].supporting_views = {0, 4, 9};
    graph.nodes[NodeAtPlace(graph, {8, 0, 0})].continuations = {{{1, 1 - end_b()}, {2, 0}}};
    graph.nodes[NodeAtPlace(graph, {0, 0, 0})].continuations = {{{0, 1 - end_a()}, {4, 1}}};
    return graph;
  }

  DrawingGraph graph_;
};

TEST_P(JoinTest, PointsSigmasAndVerticesAreInOrder) {
  Polyline3d expected = Row(0, 3);
  for (const Vector3d& point : Row(5, 8)) expected.push_back(point);
  std::vector<double> sigma = {1, 2, 3, 4};
  if (end_a() == 0) sigma = {4, 3, 2, 1};
  for (int k = 0; k < 4; ++k) sigma.push_back(end_b() == 0 ? k + 1 : 4 - k);
  if (end_a() == 0) {
    std::reverse(expected.begin(), expected.end());
    std::reverse(sigma.begin(), sigma.end());
  }
  EXPECT_EQ(graph_.links[0].points_in_world, expected);
  EXPECT_EQ(graph_.links[0].sigma, sigma);
  for (int k = 0; k < 8; ++k) {
    const LinkVertex& vertex = graph_.links[0].vertices[k];
    EXPECT_EQ(vertex.information(0, 0), sigma[k]);
    ASSERT_EQ(vertex.samples.size(), 1u);
    EXPECT_EQ(vertex.samples[0].sample, sigma[k] - 1);
  }
}

TEST_P(JoinTest, FarNodesAndContinuationsStay) {
  EXPECT_EQ(DegreeAt(graph_, {3, 0, 0}), 0);
  EXPECT_EQ(DegreeAt(graph_, {5, 0, 0}), 0);
  EXPECT_EQ(DegreeAt(graph_, {8, 0, 0}), 3);
  EXPECT_EQ(DegreeAt(graph_, {0, 0, 0}), 2);
  const LinkEnd next{1, 0};    // link 2, before link 1 went
  const LinkEnd before{3, 1};  // link 4
  EXPECT_EQ(ContinuationsAt(graph_, {8, 0, 0}),
            (PairsOfEnds{std::minmax(LinkEnd{0, end_a()}, next)}));
  EXPECT_EQ(ContinuationsAt(graph_, {0, 0, 0}),
            (PairsOfEnds{std::minmax(LinkEnd{0, 1 - end_a()}, before)}));
}

TEST_P(JoinTest, WhatIsKnownOfBothIsKept) {
  EXPECT_EQ(graph_.links[0].supporting_views, (std::vector<ViewId>{0, 1, 4, 6, 9}));
  ASSERT_EQ(graph_.links[0].members.size(), 2u);
  EXPECT_EQ(graph_.links[0].members[0].curve + graph_.links[0].members[1].curve, 1);
  EXPECT_EQ(graph_.links[0].residual_px, 0.2);
  EXPECT_FALSE(graph_.links[0].closed);
}

INSTANTIATE_TEST_SUITE_P(Ends, JoinTest,
                         ::testing::Combine(::testing::Values(0, 1), ::testing::Values(0, 1)));

TEST(JoinAtOneNodeTest, PlaceHasOnePointOfTheTwo) {
  for (const int end_a : {0, 1}) {
    for (const int end_b : {0, 1}) {
      DrawingGraph graph = GraphWithVertices(
          {end_a == 1 ? Row(0, 3) : Row(3, 0), end_b == 0 ? Row(3, 7) : Row(7, 3)});
      graph.nodes[NodeAtPlace(graph, {3, 0, 0})].continuations = {{{0, end_a}, {1, end_b}}};
      GraphEditor editor(&graph);
      editor.Join({0, end_a}, {1, end_b});
      ExpectSound(graph, "join");
      const DrawingLink& link = graph.links[0];
      EXPECT_EQ(link.points_in_world, end_a == 1 ? Row(0, 7) : Row(7, 0));
      EXPECT_EQ(NumSketchSamples(link), 9);
      EXPECT_EQ(link.vertices[end_a == 1 ? 3 : 4].samples.size(), 2u);
      EXPECT_EQ(link.vertices[end_a == 1 ? 3 : 4].support.size(), 2u);
    }
  }
}

TEST(JoinOfOneLinkTest, LoopCloses) {
  for (const int end : {0, 1}) {
    DrawingGraph graph = GraphWithVertices({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
    GraphEditor editor(&graph);
    editor.Join({0, end}, {0, 1 - end});
    ExpectSound(graph, "join");
    editor.Compact();
    ASSERT_EQ(graph.nodes.size(), 1u);
    EXPECT_EQ(graph.nodes[0].kind, NodeKind::kLoopAnchor);
    EXPECT_EQ(Continuations(graph.nodes[0]), (PairsOfEnds{{{0, 0}, {0, 1}}}));
    EXPECT_TRUE(graph.links[0].closed);
    EXPECT_EQ(graph.links[0].points_in_world, Square());
    EXPECT_EQ(graph.links[0].sigma, (std::vector<double>{1, 2, 3, 4, 1}));
    EXPECT_EQ(NumSketchSamples(graph.links[0]), 4);
  }
}

TEST(JoinOfOneLinkTest, OpenedLoopClosesWithoutAnotherPoint) {
  DrawingGraph graph = GraphWithVertices({Square()});
  GraphEditor editor(&graph);
  editor.Split(0, 2);
  editor.Free({0, 1});
  editor.Join({0, 0}, {0, 1});
  ExpectSound(graph, "join");
  EXPECT_TRUE(graph.links[0].closed);
  EXPECT_EQ(graph.links[0].size(), 5);
  EXPECT_EQ(NumSketchSamples(graph.links[0]), 4);
}

TEST(JoinOfTwoHalvesTest, LoopIsClosedWhenBothMeetingsAreJoined) {
  // The two share both nodes.
  DrawingGraph graph =
      GraphWithVertices({{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}}, {{0, 0, 0}, {1, -1, 0}, {2, 0, 0}}});
  GraphEditor editor(&graph);
  editor.Join({0, 1}, {1, 1});
  ExpectSound(graph, "join");
  EXPECT_TRUE(graph.links[0].closed);
  EXPECT_EQ(graph.links[0].size(), 5);
}

// Four links in a row, in mixed directions: whatever the order of the joins, it is one link.
TEST(NowTest, ChainsOfJoinsEndInOneLink) {
  std::vector<int> order = {0, 1, 2};
  do {
    DrawingGraph graph = GraphWithVertices({Row(0, 3), Row(8, 5), Row(10, 13), Row(18, 15)});
    GraphEditor editor(&graph);
    const std::pair<LinkEnd, LinkEnd> gaps[] = {
        {{0, 1}, {1, 1}}, {{1, 0}, {2, 0}}, {{3, 1}, {2, 1}}};
    for (const int gap : order) {
      const LinkEnd a = editor.CurrentEnd(gaps[gap].first);
      const LinkEnd b = editor.CurrentEnd(gaps[gap].second);
      ASSERT_NE(a.link, b.link);
      ASSERT_TRUE(editor.IsLink(a.link) && editor.IsLink(b.link));
      editor.Join(a, b);
      ExpectSound(graph, "join");
    }
    const LinkEnd far[] = {editor.CurrentEnd({0, 0}), editor.CurrentEnd({3, 0})};
    EXPECT_EQ(EndPoint(graph.links[far[0].link], far[0].end), Vector3d(0, 0, 0));
    EXPECT_EQ(EndPoint(graph.links[far[1].link], far[1].end), Vector3d(18, 0, 0));
    editor.Compact();
    ASSERT_EQ(graph.links.size(), 1u);
    EXPECT_EQ(Length(graph.links[0].points_in_world), 18);
    EXPECT_EQ(graph.links[0].members.size(), 4u);
    EXPECT_EQ(DegreeAt(graph, {0, 0, 0}), 1);
    EXPECT_EQ(DegreeAt(graph, {18, 0, 0}), 1);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(MoveNodeTest, AllEndsMoveWithIt) {
  DrawingGraph graph = GraphWithVertices({Row(-3, 0), Row(0, 3), Square()});
  graph.links[2].closed = false;
  GraphEditor editor(&graph);
  editor.MoveNode(NodeAtPlace(graph, {0, 0, 0}), {0, 0, 0.5});
  ExpectSound(graph, "move");
  EXPECT_EQ(graph.links[0].points_in_world.back(), Vector3d(0, 0, 0.5));
  EXPECT_EQ(graph.links[1].points_in_world.front(), Vector3d(0, 0, 0.5));
  EXPECT_EQ(graph.links[2].points_in_world.front(), Vector3d(0, 0, 0.5));
  EXPECT_EQ(graph.links[2].points_in_world.back(), Vector3d(0, 0, 0.5));
}

TEST(InsertPointTest, PointBetweenTwoIsNoSurerThanTheyAre) {
  DrawingGraph graph = GraphWithVertices({Row(0, 3)});
  GraphEditor editor(&graph);
  EXPECT_EQ(editor.InsertPoint(0, 1, 0.25), 2);
  ExpectSound(graph, "insert");
  EXPECT_EQ(graph.links[0].points_in_world[2], Vector3d(1.25, 0, 0));
  EXPECT_EQ(graph.links[0].sigma, (std::vector<double>{1, 2, 3, 3, 4}));
  EXPECT_TRUE(graph.links[0].vertices[2].support.empty());
}

TEST(UnifyTest, OneLinkRemainsWithTheViewsOfBoth) {
  DrawingGraph graph = GraphWithVertices({Row(0, 3), {{0, 1, 0}, {3, 1, 0}}});
  graph.links[0].supporting_views = {1, 4};
  graph.links[1].supporting_views = {2, 4};
  GraphEditor editor(&graph);
  editor.Unify(0, 1);
  EXPECT_FALSE(editor.IsLink(1));
  EXPECT_EQ(graph.links[0].supporting_views, (std::vector<ViewId>{1, 2, 4}));
  EXPECT_EQ(graph.links[0].members.size(), 2u);
  editor.Compact();
  ExpectValid(graph);
  EXPECT_EQ(graph.nodes.size(), 2u);
}

TEST(MakeFirmTest, DoubtGoesToo) {
  DrawingGraph graph = GraphWithVertices({Row(0, 3)});
  graph.links[0].tentative = true;
  graph.links[0].doubt = LinkDoubt::kChance;
  GraphEditor editor(&graph);
  editor.MakeFirm(0);
  EXPECT_FALSE(graph.links[0].tentative);
  ExpectValid(graph);
}

TEST(MovePointTest, OnlyThePointMoves) {
  DrawingGraph graph = GraphWithVertices({Row(0, 3)});
  GraphEditor(&graph).MovePoint(0, 2, {2, 1, 0});
  ExpectSound(graph, "move");
  EXPECT_EQ(graph.links[0].points_in_world,
            (Polyline3d{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 0, 0}}));
}

// Edits of the first link that change its course: what was found for the old one is dropped.
TEST(ForgetShapeTest, EditsOfTheCourseDropPrimitiveAndDenseClass) {
  const std::pair<const char*, void (*)(GraphEditor*)> edits[] = {
      {"Split", [](GraphEditor* editor) { editor->Split(0, 2); }},
      {"EndAt",
       [](GraphEditor* editor) {
         editor->EndAt({0, 1}, editor->AddNode({9, 1, 0}));
       }},
      {"CutTo", [](GraphEditor* editor) { editor->CutTo(0, 1, 4); }},
      {"DropOvershoot",
       [](GraphEditor* editor) {
         editor->DropOvershoot({0, 1}, {2.5, 0, 0});
       }},
      {"Join",
       [](GraphEditor* editor) {
         editor->Join({0, 1}, {1, 0});
       }},
      {"MoveNode",
       [](GraphEditor* editor) {
         editor->MoveNode(0, {0, 1, 0});
       }},
      {"MovePoint", [](GraphEditor* editor) {
         editor->MovePoint(0, 2, {2, 1, 0});
       }}};
  for (const auto& [name, edit] : edits) {
    DrawingGraph graph = GraphWithVertices({Row(0, 5), Row(7, 9)});
    for (DrawingLink& link : graph.links) {
      link.dense.emplace();
      link.primitive.emplace();
      link.primitive->shape =
          LineSegment{link.points_in_world.front(), link.points_in_world.back()};
    }
    GraphEditor editor(&graph);
    edit(&editor);
    EXPECT_FALSE(graph.links[0].dense) << name;
    EXPECT_FALSE(graph.links[0].primitive) << name;
    if (graph.links.size() == 3) {
      EXPECT_FALSE(graph.links[2].primitive) << name;  // second part
    }
  }
}

struct KindOfLink {
  LinkKind kind = LinkKind::kUnknown;
  double confidence = 0;
  bool tentative = false;
  LinkDoubt doubt = LinkDoubt::kNone;
  double rod_radius = 0;
  std::optional<RoundBody> body = std::nullopt;
};

// Joins a link 4 long to one 2 long.
DrawingLink JoinedKinds(const KindOfLink& longer, const KindOfLink& shorter) {
  DrawingGraph graph = GraphWithVertices({Row(0, 4), Row(7, 9)});
  const auto set = [](const KindOfLink& from, DrawingLink* link) {
    link->kind = from.kind;
    link->kind_confidence = from.confidence;
    link->tentative = from.tentative;
    link->doubt = from.doubt;
    link->rod_radius = from.rod_radius;
    link->body = from.body;
  };
  set(longer, &graph.links[0]);
  set(shorter, &graph.links[1]);
  GraphEditor editor(&graph);
  editor.Join({0, 1}, {1, 0});
  editor.Compact();
  ExpectValid(graph);
  return graph.links.at(0);
}

TEST(JoinKindsTest, SameKindIsKeptWithTheMeanConfidence) {
  const DrawingLink link = JoinedKinds({LinkKind::kPaint, 0.9}, {LinkKind::kPaint, 0.6});
  EXPECT_EQ(link.kind, LinkKind::kPaint);
  EXPECT_NEAR(link.kind_confidence, 0.8, 1e-12);
}

TEST(JoinKindsTest, EvidenceIsThatOfTheSurerOne) {
  DrawingGraph graph = GraphWithVertices({Row(0, 4), Row(7, 9), Row(12, 14)});
  graph.links[0].evidence = 3;
  graph.links[1].evidence = 5;
  GraphEditor editor(&graph);
  editor.Join({0, 1}, {1, 0});
  EXPECT_EQ(graph.links[0].evidence, 5);
  editor.Join({0, 1}, {2, 0});
  EXPECT_EQ(graph.links[0].evidence, 5);
}

TEST(JoinKindsTest, ConfidenceIsTheMeanOverTheLengthWhereBothAreKnown) {
  const auto joined = [](double longer, double shorter) {
    DrawingGraph graph = GraphWithVertices({Row(0, 4), Row(7, 9)});
    graph.links[0].confidence = longer;
    graph.links[1].confidence = shorter;
    GraphEditor editor(&graph);
    editor.Join({0, 1}, {1, 0});
    editor.Compact();
    return graph.links.at(0).confidence;
  };
  EXPECT_NEAR(joined(0.9, 0.6), 0.8, 1e-12);
  EXPECT_EQ(joined(-1, 0.6), -1);
  EXPECT_EQ(joined(0.9, -1), -1);
}

TEST(JoinKindsTest, UnknownPartOnlyLowersTheConfidence) {
  const DrawingLink link = JoinedKinds({}, {LinkKind::kShadow, 0.9});
  EXPECT_EQ(link.kind, LinkKind::kShadow);
  EXPECT_NEAR(link.kind_confidence, 0.3, 1e-12);
}

TEST(JoinKindsTest, LengthTimesConfidenceDecidesBetweenKinds) {
  const DrawingLink longer = JoinedKinds({LinkKind::kEdge, 0.9}, {LinkKind::kShadow, 0.9});
  EXPECT_EQ(longer.kind, LinkKind::kEdge);
  EXPECT_NEAR(longer.kind_confidence, (0.9 * 4 - 0.9 * 2) / 6, 1e-12);
  EXPECT_EQ(JoinedKinds({LinkKind::kEdge, 0.3}, {LinkKind::kShadow, 0.9}).kind, LinkKind::kShadow);
  const DrawingLink tie = JoinedKinds({LinkKind::kEdge, 0.25}, {LinkKind::kShadow, 0.5});
  EXPECT_EQ(tie.kind, LinkKind::kUnknown);
  EXPECT_EQ(tie.kind_confidence, 0);
}

TEST(JoinKindsTest, TentativeIfMostOfTheLengthIs) {
  EXPECT_TRUE(JoinedKinds({.tentative = true}, {}).tentative);
  EXPECT_FALSE(JoinedKinds({}, {.tentative = true}).tentative);
  EXPECT_TRUE(JoinedKinds({.tentative = true}, {.tentative = true}).tentative);
}

TEST(JoinKindsTest, TheDoubtIsThatOfTheLongerTentativeLink) {
  const KindOfLink chance = {.tentative = true, .doubt = LinkDoubt::kChance};
  const KindOfLink explained = {.tentative = true, .doubt = LinkDoubt::kExplained};
  EXPECT_EQ(JoinedKinds(chance, explained).doubt, LinkDoubt::kChance);
  EXPECT_EQ(JoinedKinds({.tentative = true}, explained).doubt, LinkDoubt::kExplained);
  EXPECT_EQ(JoinedKinds(chance, {}).doubt, LinkDoubt::kChance);
  EXPECT_EQ(JoinedKinds({}, chance).doubt, LinkDoubt::kNone);
}

TEST(JoinTest, ARodRemainsOneOnlyWithAnother) {
  const KindOfLink rod = {.kind = LinkKind::kRod, .confidence = 0.9, .rod_radius = 0.1};
  EXPECT_EQ(JoinedKinds(rod, rod).kind, LinkKind::kRod);
  EXPECT_EQ(JoinedKinds(rod, rod).rod_radius, 0.1);
  for (const DrawingLink& joined : {JoinedKinds(rod, {}), JoinedKinds({}, rod)}) {
    EXPECT_EQ(joined.kind, LinkKind::kUnknown);
    EXPECT_EQ(joined.rod_radius, 0);
  }
}

TEST(SetKindTest, OnlyContoursHaveABody) {
  DrawingGraph graph = GraphWithVertices({Row(0, 5)});
  graph.links[0].kind = LinkKind::kContour;
  graph.links[0].kind_confidence = 0.5;
  graph.links[0].body = {RoundShape::kCylinder, {0, 0, 0}, {0, 0, 1}, 1, 1, 0.1, 0.1};
  GraphEditor(&graph).SetKind(0, LinkKind::kContour);
  EXPECT_TRUE(graph.links[0].body);
  GraphEditor(&graph).SetKind(0, LinkKind::kEdge);
  EXPECT_FALSE(graph.links[0].body);
  ExpectValid(graph);
}

TEST(JoinTest, BodiesGoWithTheKind) {
  const RoundBody pipe = {RoundShape::kCylinder, {0, 0, 0}, {0, 0, 1}, 1, 1, 0.1, 0.1};
  const KindOfLink contour = {.kind = LinkKind::kContour, .confidence = 0.9, .body = pipe};
  const KindOfLink edge = {.kind = LinkKind::kEdge, .confidence = 0.9};
  EXPECT_EQ(JoinedKinds(contour, edge).body, pipe);
  EXPECT_EQ(JoinedKinds(edge, contour).body, std::nullopt);
  const KindOfLink sure = {.kind = LinkKind::kContour, .confidence = 1, .body = pipe};
  EXPECT_EQ(JoinedKinds({.kind = LinkKind::kEdge, .confidence = 0.1}, sure).body, pipe);
}

TEST(SplitTest, PartsAreOfTheKindOfTheWhole) {
  DrawingGraph graph = GraphWithVertices({Row(0, 5)});
  graph.links[0].kind = LinkKind::kContour;
  graph.links[0].kind_confidence = 0.5;
  graph.links[0].tentative = true;
  graph.links[0].doubt = LinkDoubt::kSeenThrough;
  GraphEditor(&graph).Split(0, 2);
  for (const DrawingLink& link : graph.links) {
    EXPECT_EQ(link.kind, LinkKind::kContour);
    EXPECT_EQ(link.kind_confidence, 0.5);
    EXPECT_TRUE(link.tentative);
    EXPECT_EQ(link.doubt, LinkDoubt::kSeenThrough);
  }
}

}  // namespace
}  // namespace limn
