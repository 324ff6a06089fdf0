// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/drawing_graph.h"

#include <cmath>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Links 0, 1, 2 from node 0 to nodes 1, 2, 3; link 3 closed at node 4.
DrawingGraph Star() {
  DrawingGraph graph;
  graph.nodes.resize(5);
  graph.nodes[1].position_in_world = {1, 0, 0};
  graph.nodes[2].position_in_world = {0, 1, 0};
  graph.nodes[3].position_in_world = {0, 0, 1};
  graph.nodes[4].position_in_world = {5, 5, 5};
  const auto add_link = [&](NodeId node0, NodeId node1, std::vector<Eigen::Vector3d> points) {
    DrawingLink link;
    link.points_in_world = std::move(points);
    link.sigma.assign(link.points_in_world.size(), 0.1);
    link.node0 = node0;
    link.node1 = node1;
    link.closed = node0 == node1;
    graph.links.push_back(link);
  };
  add_link(0, 1, {{0, 0, 0}, {0.5, 0.1, 0}, {1, 0, 0}});
  add_link(2, 0, {{0, 1, 0}, {0, 0, 0}});
  add_link(0, 3, {{0, 0, 0}, {0, 0, 1}});
  add_link(4, 4, {{5, 5, 5}, {6, 5, 5}, {6, 6, 5}, {5, 5, 5}});
  RebuildIncidence(&graph);
  graph.nodes[0].continuations = {{{0, 0}, {1, 1}}};
  return graph;
}

TEST(DrawingGraph, RebuildIncidenceFindsKindsAndDegrees) {
  const DrawingGraph graph = Star();
  EXPECT_EQ(graph.nodes[0].kind, NodeKind::kJunction);
  EXPECT_EQ(graph.nodes[0].incident, (std::vector<LinkEnd>{{0, 0}, {1, 1}, {2, 0}}));
  EXPECT_EQ(graph.nodes[1].kind, NodeKind::kEnd);
  EXPECT_EQ(graph.nodes[4].kind, NodeKind::kLoopAnchor);
  EXPECT_EQ(graph.nodes[4].Degree(), 2);
  EXPECT_THAT(Validate(graph), IsEmpty());
  EXPECT_THAT(Validate(DrawingGraph()), IsEmpty());
}

struct Breakage {
  const char* name;
  std::function<void(DrawingGraph*)> spoil;
  const char* complaint;
};

class ValidateCatches : public ::testing::TestWithParam<Breakage> {};

TEST_P(ValidateCatches, It) {
  DrawingGraph graph = Star();
  GetParam().spoil(&graph);
  EXPECT_THAT(Validate(graph), Contains(HasSubstr(GetParam().complaint)));
}

INSTANTIATE_TEST_SUITE_P(
    Invariants, ValidateCatches,
    ::testing::Values(
        Breakage{"NodeOutOfRange", [](DrawingGraph* g) { g->links[1].node0 = 9; },
                 "link 1: node out of range"},
        Breakage{"OnePoint", [](DrawingGraph* g) { g->links[1].points_in_world.resize(1); },
                 "link 1: fewer than two points"},
        Breakage{"PointNotFinite",
                 [](DrawingGraph* g) { g->links[0].points_in_world[1].x() = NAN; },
                 "link 0: point not finite"},
        Breakage{"ConfidenceAboveOne", [](DrawingGraph* g) { g->links[1].kind_confidence = 1.1; },
                 "link 1: confidence of its kind not from 0 to 1"},
        Breakage{"CurveLength", [](DrawingGraph* g) { g->links[1].curve_px = -1; },
                 "link 1: length of its curve"},
        Breakage{"Evidence", [](DrawingGraph* g) { g->links[1].evidence = INFINITY; },
                 "link 1: evidence not finite"},
        Breakage{"Confidence", [](DrawingGraph* g) { g->links[1].confidence = -0.5; },
                 "link 1: confidence not from 0 to 1"},
        Breakage{"DepthSigma", [](DrawingGraph* g) { g->links[1].depth_sigma = -2; },
                 "link 1: standard deviation of its depth below 0"},
        Breakage{"BodyOfAnEdge",
                 [](DrawingGraph* g) {
                   g->links[1].body = {RoundShape::kSphere, {0, 0, 0}, {0, 0, 0}, 1, 1, 0, 0};
                 },
                 "link 1: a body, but no contour"},
        Breakage{"TwoRadiiOfACylinder",
                 [](DrawingGraph* g) {
                   g->links[1].kind = LinkKind::kContour;
                   g->links[1].body = {RoundShape::kCylinder, {0, 0, 0}, {0, 0, 1}, 1, 2, 0, 0};
                 },
                 "link 1: a body with two radii"},
        Breakage{"NegativeRadius",
                 [](DrawingGraph* g) {
                   g->links[1].kind = LinkKind::kContour;
                   g->links[1].body = {RoundShape::kCone, {0, 0, 0}, {0, 0, 1}, -1, 2, 0, 0};
                 },
                 "link 1: a number of its body is below 0"},
        Breakage{"CylinderWithoutAxis",
                 [](DrawingGraph* g) {
                   g->links[1].kind = LinkKind::kContour;
                   g->links[1].body = {RoundShape::kCylinder, {0, 0, 0}, {0, 0, 0}, 1, 1, 0, 0};
                 },
                 "link 1: a body has no axis"},
        Breakage{"TriAngle", [](DrawingGraph* g) { g->links[1].tri_angle_deg = 91; },
                 "link 1: triangulation angle not from 0 to 90"},
        Breakage{"ConfidenceNan", [](DrawingGraph* g) { g->links[1].kind_confidence = NAN; },
                 "link 1: confidence of its kind not from 0 to 1"},
        Breakage{"RegularityThatThereIsNot",
                 [](DrawingGraph* g) {
                   g->links[1].regularity = LinkRegularity{.direction = 0, .planes = {}};
                 },
                 "link 1: it follows a regularity that there is not"},
        Breakage{"DoubtedButNotTentative",
                 [](DrawingGraph* g) { g->links[1].doubt = LinkDoubt::kChance; },
                 "link 1: doubted, but not tentative"},
        Breakage{"PrimitiveElsewhere",
                 [](DrawingGraph* g) {
                   g->links[1].primitive = LinkPrimitive{LineSegment{{0, 1, 0}, {1e6, 0, 0}}};
                 },
                 "link 1: primitive: it is not where the points of the link are"},
        Breakage{"ZeroLength",
                 [](DrawingGraph* g) {
                   for (auto& point : g->links[2].points_in_world) point.setZero();
                 },
                 "link 2: zero length"},
        Breakage{"SigmaMissing", [](DrawingGraph* g) { g->links[0].sigma.pop_back(); },
                 "link 0: as many sigmas"},
        Breakage{"EndOffItsNode",
                 [](DrawingGraph* g) { g->links[0].points_in_world.back().z() = 1e-9; },
                 "link 0: ends are not at its nodes"},
        Breakage{"ClosedWithTwoNodes", [](DrawingGraph* g) { g->links[0].closed = true; },
                 "link 0: closed"},
        Breakage{"MissingAtItsNode", [](DrawingGraph* g) { g->nodes[1].incident.clear(); },
                 "link 0: missing at its node"},
        Breakage{"IncidentOutOfRange",
                 [](DrawingGraph* g) {
                   g->nodes[1].incident.push_back({17, 0});
                 },
                 "node 1: incident link end out of range"},
        Breakage{"IncidentEndsElsewhere",
                 [](DrawingGraph* g) {
                   g->nodes[1].incident.push_back({2, 1});
                 },
                 "node 1: incident link does not end here"},
        Breakage{"ContinuationOfAStranger",
                 [](DrawingGraph* g) {
                   g->nodes[0].continuations = {{{0, 0}, {3, 1}}};
                 },
                 "node 0: continuation"},
        Breakage{
            "IncidentNotSorted",
            [](DrawingGraph* g) { std::swap(g->nodes[0].incident[0], g->nodes[0].incident[1]); },
            "node 0: incident link ends not ascending"},
        Breakage{"NodeNotFinite",
                 [](DrawingGraph* g) { g->nodes[3].position_in_world.x() = INFINITY; },
                 "node 3: position not finite"},
        Breakage{"NodeWithoutLinks", [](DrawingGraph* g) { g->nodes.emplace_back(); },
                 "node 5: no link ends here"},
        Breakage{"JunctionOfDegreeOne",
                 [](DrawingGraph* g) { g->nodes[1].kind = NodeKind::kJunction; },
                 "node 1: junction and degree"},
        Breakage{"EndOfDegreeThree", [](DrawingGraph* g) { g->nodes[0].kind = NodeKind::kEnd; },
                 "node 0: junction and degree"},
        Breakage{"LoopAnchorWithoutLoop",
                 [](DrawingGraph* g) { g->nodes[1].kind = NodeKind::kLoopAnchor; },
                 "node 1: loop anchor"},
        Breakage{"LoopAnchorOfALinkThatIsNotThere",
                 [](DrawingGraph* g) {
                   g->nodes[1].kind = NodeKind::kLoopAnchor;
                   g->nodes[1].incident = {{99, 0}, {99, 1}};
                 },
                 "node 1: loop anchor"}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(DrawingGraph, KindsHaveNames) {
  EXPECT_STREQ(NodeKindName(NodeKind::kEnd), "end");
  EXPECT_STREQ(NodeKindName(NodeKind::kJunction), "junction");
  EXPECT_STREQ(NodeKindName(NodeKind::kLoopAnchor), "loop_anchor");
}

TEST(RemoveLinks, OthersKeepTheirOrderAndContinuations) {
  DrawingGraph graph = Star();
  graph.nodes[0].continuations = {{{0, 0}, {1, 1}}, {{1, 1}, {2, 0}}};
  RemoveLinks({0, 1, 1, 0}, &graph);
  EXPECT_THAT(Validate(graph), IsEmpty());
  ASSERT_EQ(graph.links.size(), 2u);
  EXPECT_EQ(graph.links[0].points_in_world.front(), Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(graph.links[1].points_in_world.back(), Eigen::Vector3d(0, 0, 1));
  ASSERT_EQ(graph.nodes.size(), 3u);
  const DrawingNode& node = graph.nodes[graph.links[0].node1];
  EXPECT_EQ(node.Degree(), 2);
  EXPECT_EQ(node.kind, NodeKind::kEnd);
  ASSERT_EQ(node.continuations.size(), 1u);
  EXPECT_EQ(node.continuations[0].first, (LinkEnd{0, 1}));
  EXPECT_EQ(node.continuations[0].second, (LinkEnd{1, 0}));
}

TEST(RemoveLinks, NothingMayRemain) {
  DrawingGraph graph = Star();
  RemoveLinks({0, 0, 0, 0}, &graph);
  EXPECT_TRUE(graph.links.empty());
  EXPECT_TRUE(graph.nodes.empty());
}

TEST(RemoveLinks, KeepsTheRegularities) {
  DrawingGraph graph = Star();
  graph.regularities.radii = {0.5};
  graph.links[1].regularity.emplace().radius = 0;
  std::vector<uint8_t> keep(graph.links.size(), 1);
  keep[0] = 0;
  RemoveLinks(keep, &graph);
  EXPECT_THAT(Validate(graph), IsEmpty());
  EXPECT_EQ(graph.regularities.radii, std::vector<double>{0.5});
  EXPECT_EQ(graph.links[0].regularity.value().radius, 0);
}

}  // namespace
}  // namespace limn
