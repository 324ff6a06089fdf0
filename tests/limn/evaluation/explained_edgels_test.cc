// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/explained_edgels.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

DrawingLink LinkBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  DrawingLink link;
  link.points_in_world = {from, to};
  link.supporting_views = {0};
  return link;
}

TEST(ExplainedEdgels, TellTheDepthsOfTheLinksAlongThem) {
  // Two edges of 100 px, side by side.
  const std::vector<View> views = testing::FrontalViews(1, 1, 1);
  const auto curves = testing::ProjectCurves(
      views, {testing::Segment(testing::FrontalPoint(-50, 0), testing::FrontalPoint(50, 0)),
              testing::Segment(testing::FrontalPoint(-50, 30), testing::FrontalPoint(50, 30))});
  DrawingGraph graph;
  graph.links = {LinkBetween(testing::FrontalPoint(-50, 0), testing::FrontalPoint(50, 0))};
  auto explained = FindExplainedEdgels(views, curves, graph, {});
  const auto num_explained = std::ranges::count_if(
      explained[0], [](const ExplainedEdgel& edgel) { return edgel.near > 0 && edgel.is_firm; });
  EXPECT_NEAR(static_cast<double>(num_explained), 0.5 * static_cast<double>(explained[0].size()),
              4);
  const auto first = std::ranges::find_if(
      explained[0], [](const ExplainedEdgel& edgel) { return edgel.near > 0; });
  ASSERT_NE(first, explained[0].end());
  const auto middle = first - explained[0].begin() + num_explained / 2;
  EXPECT_NEAR(explained[0][middle].near, 5, 1e-4);
  EXPECT_EQ(ShareAtOtherDepths(explained), 0);

  // The same edge at half the distance: what better links explain counts, too.
  const Eigen::Vector3d center = views[0].CenterInWorld();
  graph.links.push_back(LinkBetween((center + testing::FrontalPoint(-50, 0)) / 2,
                                    (center + testing::FrontalPoint(50, 0)) / 2));
  graph.links.back().tentative = true;
  graph.links.back().doubt = LinkDoubt::kExplained;
  explained = FindExplainedEdgels(views, curves, graph, {});
  EXPECT_NEAR(explained[0][middle].near, 2.5, 1e-4);
  EXPECT_NEAR(explained[0][middle].far, 5, 1e-4);
  EXPECT_GT(ShareAtOtherDepths(explained), 0.9);
  graph.links.back().doubt = LinkDoubt::kChance;
  EXPECT_EQ(ShareAtOtherDepths(FindExplainedEdgels(views, curves, graph, {})), 0);
}

}  // namespace
}  // namespace limn
