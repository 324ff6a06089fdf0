// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/drawing_paths.h"

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn {
namespace {

using ::testing::ElementsAre;

// Straight links between nodes on a helix.
DrawingGraph GraphOf(int num_nodes, const std::vector<std::pair<int, int>>& links) {
  DrawingGraph graph;
  graph.nodes.resize(num_nodes);
  for (int n = 0; n < num_nodes; ++n) {
    graph.nodes[n].position_in_world = {std::cos(n), std::sin(n), 0.1 * n};
  }
  for (const auto& [node0, node1] : links) {
    DrawingLink link;
    link.node0 = node0;
    link.node1 = node1;
    const Eigen::Vector3d start = graph.nodes[node0].position_in_world;
    const Eigen::Vector3d end = graph.nodes[node1].position_in_world;
    link.points_in_world = {start, end};
    if (node0 == node1) {
      link.points_in_world = {start, start + Eigen::Vector3d(0, 0, 9), end};
      link.closed = true;
    }
    link.sigma.assign(link.points_in_world.size(), 0.1);
    graph.links.push_back(link);
  }
  RebuildIncidence(&graph);
  return graph;
}

NodeId Start(const DrawingGraph& graph, const PathStep& step) {
  return step.reversed ? graph.links[step.link].node1 : graph.links[step.link].node0;
}

NodeId End(const DrawingGraph& graph, const PathStep& step) {
  return step.reversed ? graph.links[step.link].node0 : graph.links[step.link].node1;
}

TEST(Components, LongestFirst) {
  // 0-1   2-3-4   5 (closed, the longest)
  const DrawingGraph graph = GraphOf(6, {{0, 1}, {2, 3}, {5, 5}, {4, 3}});
  EXPECT_THAT(ComponentsOfLinks(graph), ElementsAre(2, 1, 0, 1));
  EXPECT_THAT(ComponentsOfLinks({}), ElementsAre());
}

TEST(Paths, GoOnThroughNodesOfDegreeTwo) {
  // 0-1-2-3, links of any direction, begun in the middle.
  const DrawingGraph graph = GraphOf(4, {{2, 1}, {0, 1}, {2, 3}});
  EXPECT_THAT(PathsOf(graph), ElementsAre(DrawingPath{{2, true}, {0, false}, {1, true}}));
}

TEST(Paths, EndAtJunctionsUnlessLinksContinue) {
  // 1, 2, 3 around 0.
  DrawingGraph graph = GraphOf(4, {{0, 1}, {2, 0}, {0, 3}});
  EXPECT_THAT(PathsOf(graph), ElementsAre(DrawingPath{{0, false}}, DrawingPath{{1, false}},
                                          DrawingPath{{2, false}}));
  graph.nodes[0].continuations = {{{0, 0}, {1, 1}}};
  EXPECT_THAT(PathsOf(graph),
              ElementsAre(DrawingPath{{1, false}, {0, false}}, DrawingPath{{2, false}}));
}

TEST(Paths, RingsAndClosedLinks) {
  const DrawingGraph ring = GraphOf(3, {{0, 1}, {2, 1}, {2, 0}});
  EXPECT_THAT(PathsOf(ring), ElementsAre(DrawingPath{{0, false}, {1, true}, {2, false}}));
  const DrawingGraph closed = GraphOf(1, {{0, 0}});
  EXPECT_THAT(PathsOf(closed), ElementsAre(DrawingPath{{0, false}}));
}

TEST(Curves, GoOnThroughJunctionsButNotAroundCorners) {
  // Links 1 and 2 go on through node 0, where link 0 ends; 2 and 3 meet at a corner.
  DrawingGraph graph = GraphOf(5, {{0, 1}, {2, 0}, {0, 3}, {3, 4}});
  EXPECT_THAT(CurvesOf(graph), ElementsAre(0, 1, 2, 3));
  graph.nodes[0].continuations = {{{2, 0}, {1, 1}}};
  EXPECT_THAT(CurvesOf(graph), ElementsAre(0, 1, 1, 3));
}

TEST(Curves, AreNamedByTheirFirstLink) {
  DrawingGraph ring = GraphOf(3, {{0, 1}, {2, 1}, {2, 0}});
  ring.nodes[0].continuations = {{{0, 0}, {2, 1}}};
  ring.nodes[2].continuations = {{{1, 0}, {2, 0}}};
  EXPECT_THAT(CurvesOf(ring), ElementsAre(0, 0, 0));
  EXPECT_THAT(CurvesOf({}), ElementsAre());
}

TEST(Paths, HoldEveryLinkOnceEndToEnd) {
  std::mt19937 random(7);
  for (int round = 0; round < 50; ++round) {
    std::vector<std::pair<int, int>> links;
    for (int l = 0; l < 30; ++l) links.emplace_back(random() % 15, 15 + random() % 10);
    DrawingGraph graph = GraphOf(25, links);
    for (DrawingNode& node : graph.nodes) {
      if (node.Degree() < 3) continue;
      // Also pairs that contradict each other, as far as Validate allows.
      for (int pair = 0; pair < 2; ++pair) {
        const LinkEnd a = node.incident[random() % node.incident.size()];
        const LinkEnd b = node.incident[random() % node.incident.size()];
        if (a != b) node.continuations.emplace_back(a, b);
      }
    }
    std::vector<int> times(graph.links.size(), 0);
    for (const DrawingPath& path : PathsOf(graph)) {
      ASSERT_FALSE(path.empty());
      for (size_t i = 0; i < path.size(); ++i) {
        ++times[path[i].link];
        if (i == 0) continue;
        EXPECT_EQ(End(graph, path[i - 1]), Start(graph, path[i]));
      }
    }
    EXPECT_THAT(times, ::testing::Each(1));
  }
}

}  // namespace
}  // namespace limn
