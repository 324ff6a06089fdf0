// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/curve_set.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(CurveSet, OfADrawingHasItsLinksAndNodes) {
  DrawingGraph graph;
  graph.nodes.resize(2);
  graph.nodes[1].position_in_world = {1, 0, 0};
  DrawingLink link;
  link.points_in_world = {{0, 0, 0}, {1, 0, 0}};
  link.sigma = {0, 0};
  link.node0 = 0;
  link.node1 = 1;
  graph.links = {link};
  RebuildIncidence(&graph);
  const CurveSet set = ToCurveSet(graph);
  ASSERT_EQ(set.polylines.size(), 1u);
  EXPECT_EQ(set.polylines[0], link.points_in_world);
  ASSERT_EQ(set.nodes.size(), 2u);
  EXPECT_EQ(set.nodes[1].degree, 1);
  EXPECT_EQ(set.nodes[1].position_in_world.x(), 1);
}

TEST(CurveSet, TellsWhichLinksAreCircles) {
  DrawingGraph graph;
  graph.links.resize(3);
  CircularArc arc;
  arc.sweep_rad = 2 * M_PI;
  graph.links[1].primitive = LinkPrimitive{arc};
  arc.sweep_rad = M_PI;
  graph.links[2].primitive = LinkPrimitive{arc};
  EXPECT_EQ(ToCurveSet(graph).is_circle, std::vector<uint8_t>({0, 1, 0}));
}

TEST(CurveSet, ClosedSketchCurvesReturnToTheirStart) {
  CurveSketch sketch;
  sketch.curves.resize(2);
  for (Curve3D& curve : sketch.curves) curve.points_in_world = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  sketch.curves[1].closed = true;
  const CurveSet set = ToCurveSet(sketch);
  EXPECT_EQ(set.polylines[0].size(), 3u);
  ASSERT_EQ(set.polylines[1].size(), 4u);
  EXPECT_EQ(set.polylines[1].back(), set.polylines[1].front());
}

}  // namespace
}  // namespace limn
