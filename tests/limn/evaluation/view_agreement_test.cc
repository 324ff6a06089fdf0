// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/view_agreement.h"

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

// The edges of a cube, which all views but the last support.
DrawingGraph CubeGraph(int num_views) {
  DrawingGraph graph;
  for (const testing::SceneCurve& edge : testing::CubeEdges(0.8)) {
    DrawingLink link;
    link.points_in_world = edge.points;
    for (int v = 0; v + 1 < num_views; ++v) link.supporting_views.push_back(v);
    graph.links.push_back(std::move(link));
  }
  return graph;
}

TEST(ViewAgreement, IsTheShareOfTheCurvesOfAView) {
  const std::vector<View> views = testing::DomeViews(4, 5);
  const auto curves = testing::ProjectCurves(views, testing::CubeEdges(0.8));
  DrawingGraph graph = CubeGraph(4);
  auto agreements = MeasureAgreement(views, curves, graph);
  for (int v = 0; v < 3; ++v) EXPECT_NEAR(agreements[v].share, 1, 0.05);
  EXPECT_EQ(agreements[3].share, 0);
  EXPECT_GT(agreements[3].num_edgels, 500);
  for (size_t l = 0; l < graph.links.size(); l += 2) graph.links[l].tentative = true;
  agreements = MeasureAgreement(views, curves, graph);
  EXPECT_NEAR(agreements[0].share, 0.5, 0.1);
}

TEST(ViewAgreement, ViewsWithoutEdgesHaveNone) {
  const std::vector<View> views = testing::DomeViews(4, 5);
  const auto agreements = MeasureAgreement(views, std::vector<ImageCurves>(4), CubeGraph(4));
  EXPECT_EQ(agreements[0].num_edgels, 0);
  EXPECT_EQ(agreements[0].share, 0);
}

}  // namespace
}  // namespace limn
