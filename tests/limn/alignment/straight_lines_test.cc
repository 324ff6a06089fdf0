// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/straight_lines.h"

#include <limits>

#include <gtest/gtest.h>

#include "limn/alignment/wire_room.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

TEST(StraightLines, AreThoseWithPrimitivesThatAreLines) {
  DrawingGraph graph = testing::WireRoom();
  const size_t count = graph.links.size();
  EXPECT_EQ(StraightLines(graph).size(), count);
  graph.links[0].primitive->shape = CircularArc{};
  graph.links[1].tentative = true;
  graph.links[2].kind = LinkKind::kContour;
  EXPECT_EQ(StraightLines(graph).size(), count - 3);
}

TEST(StraightLines, WithoutPrimitivesAreThoseNearTheirChords) {
  DrawingGraph graph = testing::WireRoom();
  const size_t count = graph.links.size();
  for (DrawingLink& link : graph.links) link.primitive.reset();
  EXPECT_EQ(StraightLines(graph).size(), count);
  graph.links[0].points_in_world[1].z() += 0.06;  // of 5 m
  EXPECT_EQ(StraightLines(graph).size(), count - 1);
}

TEST(StraightLines, WeighLessWhereTheirDirectionIsUncertain) {
  DrawingGraph graph;
  for (int i = 0; i < 3; ++i) testing::AddLine({0, 0, 0}, {1, 0, 0}, &graph);
  graph.links[1].sigma.assign(3, 1 * kDeg / M_SQRT2);
  graph.links[2].sigma.assign(3, std::numeric_limits<double>::infinity());
  RebuildIncidence(&graph);
  const std::vector<StraightLine> lines = StraightLines(graph);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_NEAR(lines[0].weight, 1, 0.01);
  EXPECT_NEAR(lines[1].weight, 0.5, 1e-9);
  EXPECT_NEAR(lines[2].weight, 0.5, 1e-9);
}

}  // namespace
}  // namespace limn
