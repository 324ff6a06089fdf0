// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/geometry/polyline.h"
#include "limn/refinement/refinement.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::vector<View>& RefitViews() {
  static const std::vector<View> views = testing::FrontalViews(4, 2, 1);
  return views;
}

// The true scene: a line from x = -100 to 100 px, and a line up from its end.
const std::vector<ImageCurves>& RefitCurves() {
  static const std::vector<ImageCurves> curves = testing::ProjectCurves(
      RefitViews(),
      {testing::Segment(testing::FrontalPoint(-100, 0), testing::FrontalPoint(100, 0)),
       testing::Segment(testing::FrontalPoint(100, 0), testing::FrontalPoint(100, 90))});
  return curves;
}

void AddRefitLink(const Eigen::Vector3d& from, const Eigen::Vector3d& to, NodeId node0,
                  NodeId node1, DrawingGraph* graph) {
  DrawingLink link;
  link.points_in_world =
      ResampleUniform(std::vector<Eigen::Vector3d>{from, to}, 3 * testing::kFrontalPx);
  link.sigma.assign(link.points_in_world.size(), 0.3 * testing::kFrontalPx);
  link.node0 = node0;
  link.node1 = node1;
  for (int v = 0; v < 8; ++v) link.supporting_views.push_back(v);
  graph->links.push_back(std::move(link));
}

// Both lines in two links each, all .4 px beside the truth.
DrawingGraph DrawnLines() {
  DrawingGraph graph;
  const Eigen::Vector3d places[] = {testing::FrontalPoint(-100, 0.4), testing::FrontalPoint(0, 0.4),
                                    testing::FrontalPoint(100.4, 0.4),
                                    testing::FrontalPoint(100.4, 45),
                                    testing::FrontalPoint(100.4, 90)};
  for (const Eigen::Vector3d& place : places) {
    graph.nodes.emplace_back();
    graph.nodes.back().position_in_world = place;
  }
  for (int k = 0; k < 4; ++k) AddRefitLink(places[k], places[k + 1], k, k + 1, &graph);
  RebuildIncidence(&graph);
  graph.nodes[1].continuations = {{{0, 1}, {1, 0}}};
  graph.nodes[3].continuations = {{{2, 1}, {3, 0}}};
  return graph;
}

RefitResult RefitOf(const DrawingGraph& graph, const std::vector<uint8_t>& refit) {
  RefitResult result = RefitLinks({{RefitViews(), RefitCurves()}, graph}, refit, {}, {});
  EXPECT_THAT(Validate(result.graph), IsEmpty());
  return result;
}

double YPxOf(const DrawingLink& link, double x_px) {
  return ClosestPoint(link.points_in_world, testing::FrontalPoint(x_px, 0)).position.y() /
         testing::kFrontalPx;
}

TEST(RefitLinks, FitsWhatIsAskedAndLeavesAllElseToTheBit) {
  const DrawingGraph graph = DrawnLines();
  const RefitResult result = RefitOf(graph, {1, 0, 0, 0});
  EXPECT_THAT(result.fitted, ElementsAre(1, 0, 0, 0));
  for (int l = 1; l < 4; ++l) {
    EXPECT_EQ(result.graph.links[l].points_in_world, graph.links[l].points_in_world) << l;
    EXPECT_EQ(result.graph.links[l].sigma, graph.links[l].sigma) << l;
    EXPECT_EQ(result.graph.links[l].supporting_views, graph.links[l].supporting_views) << l;
    EXPECT_THAT(result.shown[l], IsEmpty());
  }
  const DrawingLink& fitted = result.graph.links[0];
  EXPECT_NEAR(YPxOf(fitted, -50), 0, 0.05);
  EXPECT_NEAR(YPxOf(fitted, -99), 0, 0.1);  // its free end
  // The node that another link ends at stays, and is not surer than it was.
  EXPECT_EQ(fitted.points_in_world.back(), testing::FrontalPoint(0, 0.4));
  EXPECT_GT(fitted.sigma.back(), 0.1 * testing::kFrontalPx);
}

TEST(RefitLinks, NodesOfLinksThatAreAllAskedMove) {
  const RefitResult result = RefitOf(DrawnLines(), {1, 1, 0, 0});
  EXPECT_THAT(result.fitted, ElementsAre(1, 1, 0, 0));
  EXPECT_NEAR(result.graph.nodes[1].position_in_world.y(), 0, 0.05 * testing::kFrontalPx);
  EXPECT_EQ(result.graph.nodes[2].position_in_world, testing::FrontalPoint(100.4, 0.4));
}

TEST(RefitLinks, ALinkThatNoViewShowsKeepsItsShapeAndIsUnsure) {
  DrawingGraph graph = DrawnLines();
  for (int k = 0; k < 2; ++k) {
    graph.nodes.emplace_back();
    graph.nodes.back().position_in_world = testing::FrontalPoint(-80 + 60 * k, -50);
  }
  AddRefitLink(testing::FrontalPoint(-80, -50), testing::FrontalPoint(-20, -50), 5, 6, &graph);
  RebuildIncidence(&graph);
  const RefitResult result = RefitOf(graph, {0, 0, 0, 0, 1});
  EXPECT_THAT(result.fitted, ElementsAre(0, 0, 0, 0, 0));
  EXPECT_EQ(result.graph.links[4].points_in_world, graph.links[4].points_in_world);
  for (const double sigma : result.graph.links[4].sigma) {
    EXPECT_GE(sigma, 0.99 * testing::kFrontalPx);
  }
  ASSERT_FALSE(result.shown[4].empty());
  for (const ShownPlace& place : result.shown[4]) EXPECT_EQ(place.num_views, 0);
}

// A bridge over a gap of the images is shown on both sides of it only.
TEST(RefitLinks, TellsWhereViewsShowALink) {
  DrawingGraph graph = DrawnLines();
  graph.nodes[0].position_in_world = testing::FrontalPoint(-160, 0.4);
  graph.links[0].points_in_world.insert(graph.links[0].points_in_world.begin(),
                                        testing::FrontalPoint(-160, 0.4));
  graph.links[0].sigma.push_back(graph.links[0].sigma.back());
  const RefitResult result = RefitOf(graph, {1, 0, 0, 0});
  EXPECT_TRUE(result.fitted[0]);
  for (const ShownPlace& place : result.shown[0]) {
    const double x = place.position.x() / testing::kFrontalPx;
    if (x < -110) {
      EXPECT_EQ(place.num_views, 0) << x;
    } else if (x > -90) {
      EXPECT_EQ(place.num_views, 8) << x;
    }
  }
}

TEST(RefitLinks, OutlinesAreNotFittedButFollowTheirNodes) {
  DrawingGraph graph = DrawnLines();
  graph.links[1].kind = LinkKind::kContour;
  const RefitResult result = RefitOf(graph, {1, 1, 0, 0});
  EXPECT_THAT(result.fitted, ElementsAre(1, 0, 0, 0));
  EXPECT_EQ(result.graph.links[1].kind, LinkKind::kContour);
  EXPECT_NEAR(result.graph.nodes[1].position_in_world.y(), 0, 0.1 * testing::kFrontalPx);
}

TEST(RefitLinks, WithoutRoundsNothingChanges) {
  RefinementOptions options;
  options.num_rounds = 0;
  const DrawingGraph graph = DrawnLines();
  const RefitResult result =
      RefitLinks({{RefitViews(), RefitCurves()}, graph}, {1, 1, 1, 1}, options, {});
  EXPECT_EQ(result.graph.links[0].points_in_world, graph.links[0].points_in_world);
  options.max_distance_px = -1;
  EXPECT_THROW(RefitLinks({{RefitViews(), RefitCurves()}, graph}, {1, 1, 1, 1}, options, {}),
               OptionError);
}

}  // namespace
}  // namespace limn
