#include "limn/refinement/covered_links.h"

#include <gtest/gtest.h>

#include "limn/geometry/polyline.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

void AddLink(const Eigen::Vector3d& from, const Eigen::Vector3d& to, DrawingGraph* graph) {
  DrawingLink link;
  link.points_in_world = {from, to};
  link.sigma = {0, 0};
  for (const Eigen::Vector3d& position : {from, to}) {
    graph->nodes.emplace_back();
    graph->nodes.back().position_in_world = position;
  }
  link.node0 = static_cast<NodeId>(graph->nodes.size()) - 2;
  link.node1 = link.node0 + 1;
  graph->links.push_back(link);
}

// Pixels are 8 mm large here: a long link, a short one half a pixel beside it, one at 4 px, and one
// across it.
DrawingGraph FourLinks() {
  DrawingGraph graph;
  AddLink({-0.5, 0, 0}, {0.5, 0, 0}, &graph);
  AddLink({-0.2, 0.004, 0}, {0.2, 0.004, 0}, &graph);
  AddLink({-0.2, 0.033, 0}, {0.2, 0.033, 0}, &graph);
  AddLink({0, -0.2, 0}, {0, 0.2, 0}, &graph);
  RebuildIncidence(&graph);
  return graph;
}

TEST(CoveredLinks, ShorterOfTwoOnTheSameEdgeGoes) {
  const std::vector<View> views = testing::DomeViews(4, 5);
  const auto keep = FindUncoveredLinks(MakeControlGraph(FourLinks(), views, 3));
  EXPECT_EQ(keep, (std::vector<uint8_t>{1, 0, 1, 1}));
}

TEST(CoveredLinks, RemovalLeavesAValidGraph) {
  DrawingGraph graph = FourLinks();
  // The third link goes on in the fourth; the second hangs at their node too.
  graph.links[2].node1 = graph.links[1].node1 = graph.links[3].node0;
  for (const int l : {1, 2}) {
    graph.links[l].points_in_world.back() = graph.links[3].points_in_world.front();
  }
  graph.nodes[graph.links[3].node0].continuations = {{{2, 1}, {3, 0}}};
  RemoveLinks({1, 0, 1, 1}, &graph);
  EXPECT_TRUE(Validate(graph).empty()) << Validate(graph).front();
  ASSERT_EQ(graph.links.size(), 3u);
  EXPECT_EQ(graph.nodes.size(), 5u);
  const DrawingNode& node = graph.nodes[graph.links[2].node0];
  EXPECT_EQ(node.Degree(), 2);
  ASSERT_EQ(node.continuations.size(), 1u);
  EXPECT_EQ(node.continuations[0].first, (LinkEnd{1, 1}));
  EXPECT_EQ(node.continuations[0].second, (LinkEnd{2, 0}));
}

}  // namespace
}  // namespace limn
