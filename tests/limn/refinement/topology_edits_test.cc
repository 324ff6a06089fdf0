#include "limn/refinement/topology_edits.h"

#include <gtest/gtest.h>

#include "limn/geometry/polyline.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

// Pixels are about 8 mm large here.
constexpr double kPx = 0.008;

const std::vector<View>& Views() {
  static const std::vector<View> views = testing::DomeViews(8, 5);
  return views;
}

NodeId AddNode(const Eigen::Vector3d& position, DrawingGraph* graph) {
  graph->nodes.emplace_back();
  graph->nodes.back().position_in_world = position;
  return static_cast<NodeId>(graph->nodes.size()) - 1;
}

void AddLink(const Polyline3d& points, DrawingGraph* graph) {
  DrawingLink link;
  link.points_in_world = points;
  link.sigma.assign(points.size(), kPx);
  link.node0 = AddNode(points.front(), graph);
  link.node1 = AddNode(points.back(), graph);
  for (size_t v = 0; v < Views().size(); ++v) {
    link.supporting_views.push_back(static_cast<ViewId>(v));
  }
  graph->links.push_back(link);
}

// What a drawing becomes when the images show these edges.
struct Edited {
  DrawingGraph graph;
  TopologyEditCounts counts;
};
Edited Edit(const std::vector<Polyline3d>& drawn, const std::vector<testing::SceneCurve>& seen) {
  Edited result;
  for (const Polyline3d& points : drawn) AddLink(points, &result.graph);
  RebuildIncidence(&result.graph);
  const std::vector<ImageCurves> curves = testing::ProjectCurves(Views(), seen);
  std::vector<std::unique_ptr<EdgelIndex>> edgels;
  for (const ImageCurves& of_view : curves) {
    edgels.push_back(std::make_unique<EdgelIndex>(of_view.edge_map, LinkedEdgels(of_view)));
  }
  const std::vector<uint8_t> frozen(drawn.size(), 0);
  const RefinementOptions options;
  GraphEditor editor(Views(), edgels, options, frozen, &result.graph);
  result.counts = EditTopology(&editor);
  EXPECT_TRUE(Validate(result.graph).empty()) << Validate(result.graph).front();
  return result;
}

const testing::SceneCurve& LongEdge() {
  static const auto edge = testing::Segment({-0.6, 0, 0}, {0.6, 0, 0});
  return edge;
}

TEST(TopologyEdits, EndThatRunsAlongAnotherLinkIsCutBack) {
  // The second link comes from the side and then runs half a pixel beside the first.
  const Edited edited =
      Edit({{{-0.5, 0, 0}, {0.5, 0, 0}}, {{-0.1, 0.3, 0}, {0.1, 0.004, 0}, {0.3, 0.004, 0}}},
           {LongEdge()});
  EXPECT_EQ(edited.counts.trimmed, 1);
  // What is left of it meets the first one.
  EXPECT_EQ(edited.counts.to_links, 1);
  ASSERT_EQ(edited.graph.links.size(), 3u);
  for (const Eigen::Vector3d& point : edited.graph.links[1].points_in_world) {
    EXPECT_LT(point.x(), 0.1 + 2 * kPx);
  }
}

TEST(TopologyEdits, LinkOfWhichLittleRemainsGoes) {
  const Edited edited =
      Edit({{{-0.5, 0, 0}, {0.5, 0, 0}}, {{0, 0.004, 0}, {0.2, 0.004, 0}}}, {LongEdge()});
  EXPECT_EQ(edited.graph.links.size(), 1u);
  EXPECT_EQ(edited.graph.nodes.size(), 2u);
}

TEST(TopologyEdits, EndsThatFaceEachOtherAreJoinedWhereEdgelsRun) {
  const std::vector<Polyline3d> drawn = {{{-0.5, 0, 0}, {-0.03, 0, 0}},
                                         {{0.5, 0, 0}, {0.03, 0, 0}}};
  const Edited edited = Edit(drawn, {LongEdge()});
  EXPECT_EQ(edited.counts.joined, 1);
  ASSERT_EQ(edited.graph.links.size(), 1u);
  EXPECT_NEAR(Length(edited.graph.links[0].points_in_world), 1, 1e-9);
  // With the gap in the images too the links stay apart.
  const Edited apart = Edit(drawn, {testing::Segment({-0.6, 0, 0}, {-0.03, 0, 0}),
                                    testing::Segment({0.6, 0, 0}, {0.03, 0, 0})});
  EXPECT_EQ(apart.counts.joined, 0);
  EXPECT_EQ(apart.graph.links.size(), 2u);
}

TEST(TopologyEdits, ChainOfThreeIsOneLink) {
  const Edited edited = Edit(
      {{{-0.5, 0, 0}, {-0.2, 0, 0}}, {{0.2, 0, 0}, {-0.19, 0, 0}}, {{0.21, 0, 0}, {0.5, 0, 0}}},
      {LongEdge()});
  EXPECT_EQ(edited.counts.joined, 2);
  ASSERT_EQ(edited.graph.links.size(), 1u);
  EXPECT_NEAR(Length(edited.graph.links[0].points_in_world), 1, 1e-9);
}

TEST(TopologyEdits, OpenRingIsClosed) {
  Polyline3d arc;
  for (int k = 1; k <= 119; ++k) {
    const double angle = 2 * M_PI * k / 120;
    arc.push_back({0.3 * std::cos(angle), 0.3 * std::sin(angle), 0});
  }
  const Edited edited = Edit({arc}, {testing::Circle({0, 0, 0}, 0.3)});
  ASSERT_EQ(edited.graph.links.size(), 1u);
  EXPECT_TRUE(edited.graph.links[0].closed);
  EXPECT_EQ(edited.graph.nodes.size(), 1u);
}

TEST(TopologyEdits, EndNearTheInsideOfALinkMakesATJunction) {
  const Edited edited = Edit({{{-0.5, 0, 0}, {0.5, 0, 0}}, {{0.1, 0.4, 0}, {0.1, 0.05, 0}}},
                             {LongEdge(), testing::Segment({0.1, 0.5, 0}, {0.1, 0, 0})});
  EXPECT_EQ(edited.counts.to_links, 1);
  ASSERT_EQ(edited.graph.links.size(), 3u);
  ASSERT_EQ(edited.graph.nodes.size(), 4u);
  int num_junctions = 0;
  for (const DrawingNode& node : edited.graph.nodes) {
    if (node.kind != NodeKind::kJunction) continue;
    ++num_junctions;
    EXPECT_LT((node.position_in_world - Eigen::Vector3d(0.1, 0, 0)).norm(), kPx);
    // The cut link goes on in its other part, the new one does not.
    ASSERT_EQ(node.continuations.size(), 1u);
    EXPECT_EQ(node.continuations[0].first.link, 0);
    EXPECT_EQ(node.continuations[0].second.link, 2);
  }
  EXPECT_EQ(num_junctions, 1);
}

TEST(TopologyEdits, EndNearANodeEndsThere) {
  const Edited edited = Edit({{{-0.5, 0, 0}, {0, 0, 0}}, {{0, 0.4, 0}, {0, 0.01, 0}}},
                             {LongEdge(), testing::Segment({0, 0.5, 0}, {0, 0, 0})});
  EXPECT_EQ(edited.counts.to_nodes, 1);
  EXPECT_EQ(edited.graph.nodes.size(), 3u);
}

TEST(TopologyEdits, LinksAreCutAtCornersButNotOnArcs) {
  const Polyline3d bent = {{-0.4, 0, 0}, {0, 0, 0}, {0, 0.4, 0}};
  Polyline3d arc;
  for (int k = 0; k <= 60; ++k) {
    const double angle = M_PI * k / 60;
    arc.push_back({12 * kPx * std::cos(angle), 12 * kPx * std::sin(angle), 0.3});
  }
  const Edited edited = Edit({bent, arc}, {LongEdge()});
  EXPECT_EQ(edited.counts.corners, 1);
  ASSERT_EQ(edited.graph.links.size(), 3u);
  const DrawingNode& corner = edited.graph.nodes[edited.graph.links[0].node1];
  EXPECT_LT(corner.position_in_world.norm(), kPx);
  EXPECT_TRUE(corner.continuations.empty());
}

TEST(TopologyEdits, FrozenLinksAndEmptyGraphsStay) {
  DrawingGraph graph;
  GraphEditor none(Views(), {}, {}, {}, &graph);
  EXPECT_EQ(EditTopology(&none).trimmed, 0);
  AddLink({{-0.5, 0, 0}, {0.5, 0, 0}}, &graph);
  AddLink({{0, 0.004, 0}, {0.2, 0.004, 0}}, &graph);
  RebuildIncidence(&graph);
  GraphEditor frozen(Views(), {}, {}, {1, 1}, &graph);
  EXPECT_EQ(EditTopology(&frozen).trimmed, 0);
  EXPECT_EQ(graph.links[0].points_in_world.size(), 2u);
}

}  // namespace
}  // namespace limn
