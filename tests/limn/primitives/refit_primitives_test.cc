// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/primitives/fit_primitives.h"
#include "support/noisy_drawing.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::kNoisyDrawingPx;
using testing::LineCurve;

// Two lines that meet at a right angle, and one that goes on from the second.
DrawingGraph Described() {
  testing::NoisyDrawing drawing;
  const Vector3d places[] = {{0, 0, 0}, {0.5, 0, 0}, {0.5, 0.5, 0}, {0.5, 0.5, 0.5}};
  std::vector<NodeId> nodes;
  for (const Vector3d& place : places) nodes.push_back(drawing.AddNode(place + drawing.Noise()));
  for (int k = 0; k < 3; ++k) {
    drawing.AddLink(nodes[k], nodes[k + 1], LineCurve(places[k], places[k + 1]), 0.5);
  }
  return FitPrimitives(drawing.graph(), testing::ViewsOfNoisyDrawing(), {}, {}).graph;
}

TEST(RefitPrimitives, OnlyTheAskedLinkAndItsOwnNodesChange) {
  DrawingGraph graph = Described();
  graph.regularities.radii = {1};
  graph.links[0].regularity = LinkRegularity{.radius = 0, .planes = {}};
  graph.links[2].primitive.reset();
  // Another shape of the last link, from the node on.
  for (int k = 1; k < graph.links[2].size(); ++k) {
    graph.links[2].points_in_world[k].x() += 3 * kNoisyDrawingPx;
  }
  graph.nodes[3].position_in_world = graph.links[2].points_in_world.back();
  const DrawingGraph refit =
      RefitPrimitives(graph, {0, 0, 1}, testing::ViewsOfNoisyDrawing(), {}, {});
  EXPECT_THAT(Validate(refit), ::testing::IsEmpty());
  for (int l = 0; l < 2; ++l) {
    EXPECT_EQ(refit.links[l].points_in_world, graph.links[l].points_in_world);
    ASSERT_TRUE(refit.links[l].primitive);
    EXPECT_EQ(std::get<LineSegment>(refit.links[l].primitive->shape).end,
              std::get<LineSegment>(graph.links[l].primitive->shape).end);
  }
  EXPECT_TRUE(refit.links[0].regularity);
  EXPECT_EQ(refit.nodes[2].position_in_world, graph.nodes[2].position_in_world);
  EXPECT_TRUE(refit.links[2].primitive);
}

TEST(RefitPrimitives, AskedForAllItIsFitPrimitives) {
  const DrawingGraph graph = Described();
  const DrawingGraph refit =
      RefitPrimitives(graph, {1, 1, 1}, testing::ViewsOfNoisyDrawing(), {}, {});
  const DrawingGraph fitted = FitPrimitives(graph, testing::ViewsOfNoisyDrawing(), {}, {}).graph;
  for (int l = 0; l < 3; ++l) {
    EXPECT_EQ(refit.links[l].points_in_world, fitted.links[l].points_in_world);
  }
}

}  // namespace
}  // namespace limn
