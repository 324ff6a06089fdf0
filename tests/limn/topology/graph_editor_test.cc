#include "limn/topology/graph_editor.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "limn/geometry/polyline.h"
#include "limn/topology/graph_fixture.h"
#include "limn/topology/link_geometry.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::Continuations;
using testing::ContinuationsAt;
using testing::DegreeAt;
using testing::ExpectValid;
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

// Vertices of which each has a sample and an edgel of its own; the last of a loop has none.
void GiveVertices(DrawingGraph* graph) {
  for (LinkId id = 0; id < static_cast<LinkId>(graph->links.size()); ++id) {
    DrawingLink& link = graph->links[id];
    for (int k = 0; k < link.size(); ++k) {
      LinkVertex vertex = {(k + 1) * Eigen::Matrix3d::Identity(), 1, k, {}, {}};
      if (!link.closed || k + 1 < link.size()) {
        vertex.support = {{id, k}};
        vertex.samples = {{id, k}};
      }
      link.vertices.push_back(std::move(vertex));
    }
  }
}

// Lines as links with vertices; ends at one place share a node.
DrawingGraph GraphOf(const std::vector<Polyline3d>& lines) {
  DrawingGraph graph = testing::GraphOf(lines);
  GiveVertices(&graph);
  return graph;
}

// The samples of a link's points, in order, as their numbers on the curve.
std::vector<std::vector<int>> Samples(const DrawingLink& link) {
  std::vector<std::vector<int>> samples;
  for (const LinkVertex& vertex : link.vertices) {
    samples.emplace_back();
    for (const SketchSample& sample : vertex.samples) samples.back().push_back(sample.sample);
  }
  return samples;
}

// What holds after every edit. `graph` may have gaps.
void ExpectSound(const DrawingGraph& graph, const std::string& what) {
  DrawingGraph compact = graph;
  GraphEditor(&compact).Compact();
  const std::vector<std::string> broken = Validate(compact);
  ASSERT_TRUE(broken.empty()) << what << ": " << broken.front();
  for (size_t l = 0; l < compact.links.size(); ++l) {
    const DrawingLink& link = compact.links[l];
    ASSERT_EQ(link.sigma.size(), link.points_in_world.size()) << what << ": link " << l;
    ASSERT_EQ(link.vertices.size(), link.points_in_world.size()) << what << ": link " << l;
    const bool alone = link.node0 == link.node1 && compact.nodes[link.node0].Degree() == 2;
    ASSERT_EQ(link.closed, alone) << what << ": link " << l;
    for (const LinkVertex& vertex : link.vertices) {
      ASSERT_TRUE(std::is_sorted(vertex.support.begin(), vertex.support.end())) << what;
    }
  }
  for (const DrawingNode& node : compact.nodes) {
    const bool is_anchor = node.Degree() == 2 && compact.links[node.incident[0].link].closed;
    ASSERT_EQ(node.kind == NodeKind::kLoopAnchor, is_anchor) << what;
    std::set<LinkEnd> continued;
    for (const auto& [a, b] : node.continuations) {
      ASSERT_TRUE(continued.insert(a).second && continued.insert(b).second) << what;
    }
  }
}

TEST(GraphEditorTest, AddMakesTheNodesThatAreNotGiven) {
  DrawingGraph graph = GraphOf({Row(0, 3)});
  GraphEditor editor(&graph);
  DrawingLink link = GraphOf({Row(3, 7)}).links[0];
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
  DrawingLink link = GraphOf({Square()}).links[0];
  link.node0 = link.node1 = -1;
  link.closed = false;
  editor.Add(link);
  ExpectSound(graph, "add");
  EXPECT_TRUE(graph.links[0].closed);
  ASSERT_EQ(graph.nodes.size(), 1u);
  EXPECT_EQ(graph.nodes[0].kind, NodeKind::kLoopAnchor);
}

TEST(GraphEditorTest, LoopAtAJunctionIsNotClosedUntilItIsAlone) {
  DrawingGraph graph = GraphOf({Square()});
  GraphEditor editor(&graph);
  DrawingLink link = GraphOf({Row(-3, 0)}).links[0];
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
  DrawingGraph graph = GraphOf({Row(0, 3), Row(3, 6), Row(6, 9)});
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
  DrawingGraph graph = GraphOf({Row(-3, 0), Row(0, 3), {{0, 0, 0}, {0, 3, 0}}});
  graph.nodes[NodeAtPlace(graph, {0, 0, 0})].continuations = {{{0, 1}, {1, 0}}};
  GraphEditor editor(&graph);
  editor.Remove(1);
  ExpectSound(graph, "remove");
  EXPECT_TRUE(ContinuationsAt(graph, {0, 0, 0}).empty());
}

TEST(GraphEditorTest, KeepRemovesTheOthersAndKeepsTheOrder) {
  DrawingGraph graph = GraphOf({Row(0, 3), Row(3, 6), Row(6, 9), Row(20, 22)});
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
  DrawingGraph graph = GraphOf({Row(0, 3)});
  GraphEditor editor(&graph);
  const NodeId node = editor.AddNode({5, 5, 5});
  EXPECT_FALSE(editor.IsNode(node));
  editor.Compact();
  EXPECT_EQ(graph.nodes.size(), 2u);
  ExpectSound(graph, "compact");
}

TEST(SplitTest, OpenLinkIsCutInTwoThatShareThePoint) {
  for (const int index : {1, 2, 4}) {
    DrawingGraph graph = GraphOf({Row(0, 5)});
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
  // Links 0 and 1 go on in each other, and so do 2 and 0 at its other end.
  DrawingGraph graph = GraphOf({Row(0, 5), Row(5, 9), Row(-4, 0)});
  graph.nodes[NodeAtPlace(graph, {5, 0, 0})].continuations = {{{0, 1}, {1, 0}}};
  graph.nodes[NodeAtPlace(graph, {0, 0, 0})].continuations = {{{2, 1}, {0, 0}}};
  GraphEditor(&graph).Split(0, 3);
  ExpectSound(graph, "split");
  EXPECT_EQ(ContinuationsAt(graph, {5, 0, 0}), (Pairs{{{1, 0}, {3, 1}}}));
  EXPECT_EQ(ContinuationsAt(graph, {0, 0, 0}), (Pairs{{{0, 0}, {2, 1}}}));
}

TEST(SplitTest, LinkThatReturnsToAJunctionKeepsItsContinuationThere) {
  DrawingGraph graph = GraphOf({{{-1, 0, 0}, {0, 0, 0}}, Square()});
  graph.links[1].closed = false;  // another link ends at its node
  graph.nodes[NodeAtPlace(graph, {0, 0, 0})].continuations = {{{1, 0}, {1, 1}}};
  GraphEditor(&graph).Split(1, 2);
  ExpectSound(graph, "split");
  EXPECT_EQ(ContinuationsAt(graph, {0, 0, 0}), (Pairs{{{1, 0}, {2, 1}}}));
}

TEST(SplitTest, ClosedLinkBeginsAndEndsAtThePoint) {
  for (const int index : {0, 1, 2, 3, 4}) {
    DrawingGraph graph = GraphOf({Square()});
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
  DrawingGraph graph = GraphOf({Square(), {{5, 1, 0}, {2, 1, 0}}});
  GraphEditor editor(&graph);
  const NodeId node = editor.Split(0, 2);
  editor.EndAt({1, 1}, node);
  ExpectSound(graph, "end at");
  EXPECT_FALSE(graph.links[0].closed);
  EXPECT_EQ(graph.nodes[node].kind, NodeKind::kJunction);
  EXPECT_EQ(graph.nodes[node].Degree(), 3);
}

TEST(OpenTest, LoopHasTwoFreeEndsAtThePoint) {
  for (const int index : {0, 1, 3}) {
    DrawingGraph graph = GraphOf({Square()});
    GraphEditor editor(&graph);
    editor.Open(0, index);
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
    DrawingGraph graph = GraphOf({end == 1 ? Row(0, 10) : Row(10, 0),
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
    DrawingGraph graph = GraphOf({end == 1 ? Row(0, length) : Row(length, 0)});
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
  DrawingGraph graph = GraphOf({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.1, 0.9, 0}}});
  GraphEditor editor(&graph);
  editor.EndAt({0, 1}, graph.links[0].node0);
  ExpectSound(graph, "end at");
  EXPECT_TRUE(graph.links[0].closed);
  EXPECT_EQ(graph.links[0].points_in_world,
            (Polyline3d{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.1, 0.9, 0}, {0, 0, 0}}));
}

TEST(FreeTest, EndGetsANodeOfItsOwnAtTheSamePlace) {
  DrawingGraph graph = GraphOf({Row(-3, 0), Row(0, 3), {{0, 0, 0}, {0, 3, 0}}});
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
  DrawingGraph graph = GraphOf({Row(0, 9), Row(9, 12), Row(-3, 0)});
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
  DrawingGraph graph = GraphOf({Row(10, 19), Row(19, 22), Square()});
  const LinkId loop = 2;
  GraphEditor editor(&graph);
  editor.CutTo(0, 0, 10);
  editor.CutTo(loop, 0, 5);
  ExpectSound(graph, "cut");
  EXPECT_FALSE(editor.IsFree({0, 1}));
}

TEST(CutToTest, LoopThatIsCutIsOpen) {
  DrawingGraph graph = GraphOf({Square()});
  GraphEditor editor(&graph);
  editor.CutTo(0, 1, 5);
  ExpectSound(graph, "cut");
  EXPECT_FALSE(graph.links[0].closed);
  EXPECT_EQ(editor.FreeEnds(), (std::vector<LinkEnd>{{0, 0}, {0, 1}}));
  EXPECT_EQ(Length(graph.links[0].points_in_world), 3);
}

TEST(DropOvershootTest, PointsBeyondThePlaceAreCutOff) {
  for (const int end : {0, 1}) {
    DrawingGraph graph = GraphOf({end == 1 ? Row(0, 9) : Row(9, 0), Row(9, 12)});
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
  DrawingGraph graph = GraphOf({Row(0, 9), Row(9, 12)});
  GraphEditor editor(&graph);
  editor.DropOvershoot({0, 1}, {9.5, 0, 0});
  ExpectSound(graph, "drop");
  EXPECT_EQ(graph.links[0].points_in_world, Row(0, 9));
  EXPECT_FALSE(editor.IsFree({0, 1}));
}

TEST(DropOvershootTest, SomePointsAreKept) {
  for (const int min_points : {2, 5}) {
    DrawingGraph graph = GraphOf({Row(0, 9)});
    GraphEditor(&graph).DropOvershoot({0, 1}, {-20, 0, 0}, min_points);
    ExpectSound(graph, "drop");
    EXPECT_EQ(graph.links[0].size(), min_points);
    EXPECT_EQ(NumSketchSamples(graph.links[0]), 10);
  }
}

// Links along the x axis from 0 to 3 and from 5 to 8, each in either direction, that become one.
// At their far ends other links go on.
class JoinTest : public ::testing::TestWithParam<std::tuple<int, int>> {
 protected:
  int end_a() const { return std::get<0>(GetParam()); }
  int end_b() const { return std::get<1>(GetParam()); }

  JoinTest() : graph_(Apart()) {
    GraphEditor editor(&graph_);
    editor.Join({0, end_a()}, {1, end_b()});
    ExpectSound(graph_, "join");
    EXPECT_FALSE(editor.IsLink(1));
    EXPECT_EQ(editor.Now({1, 1 - end_b()}), (LinkEnd{0, end_a()}));
    EXPECT_EQ(editor.Now({0, 1 - end_a()}), (LinkEnd{0, 1 - end_a()}));
    EXPECT_EQ(editor.Now({2, 0}), (LinkEnd{2, 0}));
    editor.Compact();
  }

  DrawingGraph Apart() const {
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
  EXPECT_EQ(ContinuationsAt(graph_, {8, 0, 0}), (Pairs{std::minmax(LinkEnd{0, end_a()}, next)}));
  EXPECT_EQ(ContinuationsAt(graph_, {0, 0, 0}),
            (Pairs{std::minmax(LinkEnd{0, 1 - end_a()}, before)}));
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
      DrawingGraph graph =
          GraphOf({end_a == 1 ? Row(0, 3) : Row(3, 0), end_b == 0 ? Row(3, 7) : Row(7, 3)});
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
    DrawingGraph graph = GraphOf({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
    GraphEditor editor(&graph);
    editor.Join({0, end}, {0, 1 - end});
    ExpectSound(graph, "join");
    editor.Compact();
    ASSERT_EQ(graph.nodes.size(), 1u);
    EXPECT_EQ(graph.nodes[0].kind, NodeKind::kLoopAnchor);
    EXPECT_EQ(Continuations(graph.nodes[0]), (Pairs{{{0, 0}, {0, 1}}}));
    EXPECT_TRUE(graph.links[0].closed);
    EXPECT_EQ(graph.links[0].points_in_world, Square());
    EXPECT_EQ(graph.links[0].sigma, (std::vector<double>{1, 2, 3, 4, 1}));
    EXPECT_EQ(NumSketchSamples(graph.links[0]), 4);
  }
}

TEST(JoinOfOneLinkTest, OpenedLoopClosesWithoutAnotherPoint) {
  DrawingGraph graph = GraphOf({Square()});
  GraphEditor editor(&graph);
  editor.Open(0, 2);
  editor.Join({0, 0}, {0, 1});
  ExpectSound(graph, "join");
  EXPECT_TRUE(graph.links[0].closed);
  EXPECT_EQ(graph.links[0].size(), 5);
  EXPECT_EQ(NumSketchSamples(graph.links[0]), 4);
}

TEST(JoinOfTwoHalvesTest, LoopIsClosedWhenBothMeetingsAreJoined) {
  // The two share both nodes.
  DrawingGraph graph =
      GraphOf({{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}}, {{0, 0, 0}, {1, -1, 0}, {2, 0, 0}}});
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
    DrawingGraph graph = GraphOf({Row(0, 3), Row(8, 5), Row(10, 13), Row(18, 15)});
    GraphEditor editor(&graph);
    const std::pair<LinkEnd, LinkEnd> gaps[] = {
        {{0, 1}, {1, 1}}, {{1, 0}, {2, 0}}, {{3, 1}, {2, 1}}};
    for (const int gap : order) {
      const LinkEnd a = editor.Now(gaps[gap].first);
      const LinkEnd b = editor.Now(gaps[gap].second);
      ASSERT_NE(a.link, b.link);
      ASSERT_TRUE(editor.IsLink(a.link) && editor.IsLink(b.link));
      editor.Join(a, b);
      ExpectSound(graph, "join");
    }
    const LinkEnd far[] = {editor.Now({0, 0}), editor.Now({3, 0})};
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

TEST(ReverseTest, PointsAndWhatIsKnownOfThemTurnAround) {
  DrawingGraph graph = GraphOf({Row(0, 3), Row(3, 5), Row(-2, 0)});
  graph.nodes[NodeAtPlace(graph, {3, 0, 0})].continuations = {{{0, 1}, {1, 0}}};
  graph.nodes[NodeAtPlace(graph, {0, 0, 0})].continuations = {{{2, 1}, {0, 0}}};
  GraphEditor(&graph).Reverse(0);
  ExpectSound(graph, "reverse");
  EXPECT_EQ(graph.links[0].points_in_world, Row(3, 0));
  EXPECT_EQ(graph.links[0].sigma, (std::vector<double>{4, 3, 2, 1}));
  EXPECT_EQ(Samples(graph.links[0]), (std::vector<std::vector<int>>{{3}, {2}, {1}, {0}}));
  EXPECT_EQ(ContinuationsAt(graph, {3, 0, 0}), (Pairs{{{0, 0}, {1, 0}}}));
  EXPECT_EQ(ContinuationsAt(graph, {0, 0, 0}), (Pairs{{{0, 1}, {2, 1}}}));
}

TEST(ReverseTest, BothEndsMayBeAtOneNode) {
  DrawingGraph graph = GraphOf({Square(), Row(-3, 0), Row(0, -3)});
  graph.links[0].closed = false;
  const NodeId node = NodeAtPlace(graph, {0, 0, 0});
  graph.nodes[node].continuations = {{{0, 0}, {1, 1}}};
  GraphEditor(&graph).Reverse(0);
  ExpectSound(graph, "reverse");
  EXPECT_EQ(graph.links[0].points_in_world, Reversed(Square()));
  EXPECT_EQ(Continuations(graph.nodes[node]), (Pairs{{{0, 1}, {1, 1}}}));
}

TEST(MoveNodeTest, AllEndsMoveWithIt) {
  DrawingGraph graph = GraphOf({Row(-3, 0), Row(0, 3), Square()});
  graph.links[2].closed = false;
  GraphEditor editor(&graph);
  editor.MoveNode(NodeAtPlace(graph, {0, 0, 0}), {0, 0, 0.5});
  ExpectSound(graph, "move");
  EXPECT_EQ(graph.links[0].points_in_world.back(), Vector3d(0, 0, 0.5));
  EXPECT_EQ(graph.links[1].points_in_world.front(), Vector3d(0, 0, 0.5));
  EXPECT_EQ(graph.links[2].points_in_world.front(), Vector3d(0, 0, 0.5));
  EXPECT_EQ(graph.links[2].points_in_world.back(), Vector3d(0, 0, 0.5));
}

TEST(MovePointTest, OnlyThePointMoves) {
  DrawingGraph graph = GraphOf({Row(0, 3)});
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
      {"Reverse", [](GraphEditor* editor) { editor->Reverse(0); }},
      {"MoveNode",
       [](GraphEditor* editor) {
         editor->MoveNode(0, {0, 1, 0});
       }},
      {"MovePoint", [](GraphEditor* editor) {
         editor->MovePoint(0, 2, {2, 1, 0});
       }}};
  for (const auto& [name, edit] : edits) {
    DrawingGraph graph = GraphOf({Row(0, 5), Row(7, 9)});
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

// A random graph and its random edits. What they do to the samples is counted beside.
class RandomEdits {
 public:
  explicit RandomEdits(unsigned seed) : random_(seed), editor_(&graph_) {
    for (int i = 0; i < 12; ++i) AddRandom();
  }

  // One edit; its name.
  std::string Step() {
    using Edit = std::string (RandomEdits::*)();
    static constexpr Edit kEdits[] = {
        &RandomEdits::Add,     &RandomEdits::Split,    &RandomEdits::Split,
        &RandomEdits::Open,    &RandomEdits::EndAt,    &RandomEdits::EndAt,
        &RandomEdits::Free,    &RandomEdits::CutTo,    &RandomEdits::DropOvershoot,
        &RandomEdits::Join,    &RandomEdits::Join,     &RandomEdits::Join,
        &RandomEdits::Reverse, &RandomEdits::MoveNode, &RandomEdits::MovePoint,
        &RandomEdits::Remove,  &RandomEdits::Keep,     &RandomEdits::Compact};
    const auto edit = kEdits[Int(static_cast<int>(std::size(kEdits)))];
    const std::string name = (this->*edit)();
    if (!name.empty()) ++num_edits_[name];
    return name;
  }

  void ExpectAsCounted(const std::string& what) const {
    ExpectSound(graph_, what);
    std::multiset<SketchSample> found;
    for (const DrawingLink& link : graph_.links) {
      for (const LinkVertex& vertex : link.vertices) {
        found.insert(vertex.samples.begin(), vertex.samples.end());
      }
    }
    ASSERT_EQ(found, samples_) << what;
  }

  const std::map<std::string, int>& num_edits() const { return num_edits_; }

 private:
  int Int(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  double Uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  // On a small grid, so that points and lines coincide often.
  Vector3d Place() {
    return {static_cast<double>(Int(5)), static_cast<double>(Int(5)), static_cast<double>(Int(3))};
  }

  // -1 if there is none.
  LinkId SomeLink(bool closed_only = false) {
    std::vector<LinkId> links;
    for (LinkId id = 0; id < editor_.NumLinks(); ++id) {
      if (editor_.IsLink(id) && (!closed_only || editor_.link(id).closed)) links.push_back(id);
    }
    return links.empty() ? -1 : links[Int(static_cast<int>(links.size()))];
  }
  NodeId SomeNode() {
    std::vector<NodeId> nodes;
    for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) {
      if (editor_.IsNode(id)) nodes.push_back(id);
    }
    return nodes.empty() ? -1 : nodes[Int(static_cast<int>(nodes.size()))];
  }

  void AddRandom() {
    DrawingLink link;
    const int curve = num_curves_++;
    const int size = 2 + Int(6);
    for (int k = 0; k < size; ++k) {
      Vector3d point = Place();
      while (k > 0 && point == link.points_in_world.back()) point = Place();
      link.points_in_world.push_back(point);
    }
    // At a node, and back to where it begins; no point twice in a row.
    Polyline3d& points = link.points_in_world;
    const NodeId node = Int(3) == 0 ? SomeNode() : -1;
    if (node >= 0 && editor_.node(node).position_in_world != points[1]) {
      link.node0 = node;
      points.front() = editor_.node(node).position_in_world;
    }
    if (size > 3 && Int(3) == 0 && points.front() != points[size - 2]) {
      points.back() = points.front();
    }
    for (int k = 0; k < size; ++k) {
      const SketchSample sample = {curve, k};
      link.sigma.push_back(k);
      link.vertices.push_back({Eigen::Matrix3d::Identity(), 1, 0, {{curve % 5, k}}, {sample}});
      samples_.insert(sample);
    }
    editor_.Add(std::move(link));
  }

  std::string Add() {
    if (samples_.size() > 150) return "";
    AddRandom();
    return "Add";
  }

  std::string Split() {
    const LinkId id = SomeLink();
    if (id < 0) return "";
    const DrawingLink& link = editor_.link(id);
    if (link.closed) {
      const int index = Int(link.size());
      const Vector3d place = link.points_in_world[index];
      const NodeId node = editor_.Split(id, index);
      EXPECT_EQ(editor_.node(node).position_in_world, place);
      return "Split closed";
    }
    if (link.size() < 3) return "";
    const int index = 1 + Int(link.size() - 2);
    // Parts must have a length.
    const Polyline3d& points = link.points_in_world;
    if (!(Length(Polyline3d(points.begin(), points.begin() + index + 1)) > 0) ||
        !(Length(Polyline3d(points.begin() + index, points.end())) > 0)) {
      return "";
    }
    editor_.Split(id, index);
    return "Split";
  }

  std::string Open() {
    const LinkId id = SomeLink(true);
    if (id < 0) return "";
    editor_.Open(id, Int(editor_.link(id).size()));
    return "Open";
  }

  std::string EndAt() {
    const std::vector<LinkEnd> ends = editor_.FreeEnds();
    if (ends.empty()) return "";
    const LinkEnd end = ends[Int(static_cast<int>(ends.size()))];
    const NodeId node = Int(4) == 0 ? editor_.AddNode(Place()) : SomeNode();
    if (node == editor_.NodeAt(end)) return "";
    if (!KeepsLength(end, editor_.node(node).position_in_world)) return "";
    editor_.EndAt(end, node);
    EXPECT_EQ(editor_.NodeAt(end), node);
    return "EndAt";
  }

  // A link of two points does not end where it begins.
  bool KeepsLength(const LinkEnd& end, const Vector3d& place) const {
    const DrawingLink& link = editor_.link(end.link);
    return link.size() > 2 || EndPoint(link, 1 - end.end) != place;
  }

  std::string Free() {
    const LinkId id = SomeLink();
    if (id < 0) return "";
    const LinkEnd end = {id, Int(2)};
    editor_.Free(end);
    EXPECT_TRUE(editor_.IsFree(end));
    return "Free";
  }

  std::string CutTo() {
    const LinkId id = SomeLink();
    if (id < 0) return "";
    const DrawingLink& link = editor_.link(id);
    const int begin = Int(link.size() - 1);
    const int end = begin + 2 + Int(link.size() - begin - 1);
    const Polyline3d& points = link.points_in_world;
    if (!(Length(Polyline3d(points.begin() + begin, points.begin() + end)) > 0)) return "";
    for (int k = 0; k < link.size(); ++k) {
      if (k >= begin && k < end) continue;
      for (const SketchSample& sample : link.vertices[k].samples) {
        samples_.erase(samples_.find(sample));
      }
    }
    editor_.CutTo(id, begin, end);
    EXPECT_EQ(editor_.link(id).size(), end - begin);
    return "CutTo";
  }

  std::string DropOvershoot() {
    const LinkId id = SomeLink();
    if (id < 0) return "";
    editor_.DropOvershoot({id, Int(2)}, Place() + Vector3d(Uniform(0, 1), 0, 0), 2 + Int(2));
    return "DropOvershoot";
  }

  // Of two free ends, or the two that are alone at a node.
  std::string Join() {
    LinkEnd a, b;
    std::string name = "Join";
    if (Int(2) == 0) {
      const NodeId node = SomeNode();
      if (node < 0 || editor_.node(node).Degree() != 2) return "";
      a = editor_.node(node).incident[0];
      b = editor_.node(node).incident[1];
      name += " at a node";
    } else {
      const std::vector<LinkEnd> ends = editor_.FreeEnds();
      if (ends.size() < 2) return "";
      const int i = Int(static_cast<int>(ends.size()));
      int j = Int(static_cast<int>(ends.size()));
      if (i == j) return "";
      if (Int(4) == 0 && editor_.IsFree({ends[i].link, 1 - ends[i].end})) {
        a = ends[i];
        b = {a.link, 1 - a.end};
      } else {
        a = ends[i];
        b = ends[j];
      }
    }
    if (Int(2) == 0) std::swap(a, b);
    const bool is_loop = a.link == b.link;
    const Vector3d far = EndPoint(editor_.link(b.link), 1 - b.end);
    editor_.Join(a, b);
    if (is_loop) {
      EXPECT_TRUE(editor_.link(a.link).closed);
      return name + " to a loop";
    }
    EXPECT_FALSE(editor_.IsLink(b.link));
    const LinkEnd now = editor_.Now({b.link, 1 - b.end});
    EXPECT_EQ(EndPoint(editor_.link(now.link), now.end), far);
    return name;
  }

  std::string Reverse() {
    const LinkId id = SomeLink();
    if (id < 0) return "";
    const Polyline3d before = editor_.link(id).points_in_world;
    editor_.Reverse(id);
    EXPECT_EQ(editor_.link(id).points_in_world, Reversed(before));
    return "Reverse";
  }

  std::string MoveNode() {
    const NodeId node = SomeNode();
    if (node < 0) return "";
    // Off the grid: no link loses its length.
    editor_.MoveNode(node, Place() + Vector3d(Uniform(0.1, 0.4), 0, Uniform(0.1, 0.4)));
    return "MoveNode";
  }

  std::string MovePoint() {
    const LinkId id = SomeLink();
    if (id < 0 || editor_.link(id).size() < 3) return "";
    editor_.MovePoint(id, 1 + Int(editor_.link(id).size() - 2),
                      Place() + Vector3d(0, Uniform(0.1, 0.4), 0));
    return "MovePoint";
  }

  void Forget(LinkId id) {
    for (const LinkVertex& vertex : editor_.link(id).vertices) {
      for (const SketchSample& sample : vertex.samples) samples_.erase(samples_.find(sample));
    }
  }

  std::string Remove() {
    const LinkId id = SomeLink();
    if (id < 0) return "";
    Forget(id);
    editor_.Remove(id);
    return "Remove";
  }

  std::string Keep() {
    if (Int(5) != 0) return "";
    std::vector<uint8_t> keep(editor_.NumLinks(), 1);
    for (LinkId id = 0; id < editor_.NumLinks(); ++id) {
      if (Int(6) != 0 || !editor_.IsLink(id)) continue;
      keep[id] = 0;
      Forget(id);
    }
    editor_.Keep(keep);
    return "Keep";
  }

  std::string Compact() {
    if (Int(4) != 0) return "";
    editor_.Compact();
    return "Compact";
  }

  std::mt19937 random_;
  DrawingGraph graph_;
  GraphEditor editor_;
  int num_curves_ = 0;
  std::multiset<SketchSample> samples_;
  std::map<std::string, int> num_edits_;
};

class RandomEditsTest : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomEditsTest, GraphIsSoundAfterEveryEdit) {
  RandomEdits edits(GetParam());
  edits.ExpectAsCounted("the first links");
  if (HasFatalFailure()) return;
  for (int step = 0; step < 1500; ++step) {
    const std::string name = edits.Step();
    edits.ExpectAsCounted("step " + std::to_string(step) + ", " + name);
    if (HasFatalFailure()) return;
  }
  for (const char* name :
       {"Add", "Split", "Split closed", "Open", "EndAt", "Free", "CutTo", "DropOvershoot", "Join",
        "Join at a node", "Join to a loop", "Join at a node to a loop", "Reverse", "MoveNode",
        "MovePoint", "Remove", "Keep", "Compact"}) {
    EXPECT_TRUE(edits.num_edits().contains(name)) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomEditsTest, ::testing::Range(1u, 13u));

}  // namespace
}  // namespace limn
