// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/editing/edited_plane.h"

namespace limn {
namespace {

using testing::DegreeAt;
using testing::DenseLine;
using testing::DenseRing;
using testing::Edited;
using ::testing::ElementsAre;
using testing::FrontalPoint;
using testing::GraphOf;
using testing::kFrontalPx;
using testing::RefTo;
using testing::RefToLine;
using testing::Refused;

DrawingGraph WithEqualSigmas(DrawingGraph graph) {
  for (DrawingLink& link : graph.links) link.sigma.assign(link.sigma.size(), 0.1);
  return graph;
}

MergeLinks MergeOf(const LinkRef& a, const LinkRef& b) { return {{a, b}}; }

double YOf(const DrawingLink& link, double x_px) {
  return ClosestPoint(link.points_in_world, FrontalPoint(x_px, 0)).position.y() / kFrontalPx;
}

TEST(MergeEdit, AShorterLinkIsTakenOverAndTheirMeanRemains) {
  DrawingGraph graph = WithEqualSigmas(GraphOf({DenseLine(20, 4, 80, 4), DenseLine(0, 0, 120, 0)}));
  graph.links[0].supporting_views = {0, 3};
  graph.links[1].supporting_views = {1, 3};
  const EditedDrawing edited =
      Edited(graph, {MergeOf(RefToLine(20, 4, 80, 4), RefToLine(0, 0, 120, 0))});
  ASSERT_EQ(edited.graph.links.size(), 1u);
  const DrawingLink& link = edited.graph.links[0];
  EXPECT_THAT(link.supporting_views, ElementsAre(0, 1, 3));
  EXPECT_NEAR(YOf(link, 50), 2, 0.01);
  EXPECT_NEAR(YOf(link, 5), 0, 0.01);
  EXPECT_EQ(link.points_in_world.back(), FrontalPoint(120, 0));
  EXPECT_THAT(edited.touched, ElementsAre(1));
}

TEST(MergeEdit, TheSurerLinkWeighsMore) {
  DrawingGraph graph = WithEqualSigmas(GraphOf({DenseLine(0, 3, 100, 3), DenseLine(0, 0, 100, 0)}));
  graph.links[0].sigma.assign(graph.links[0].sigma.size(), 0.2);
  const EditedDrawing edited =
      Edited(graph, {MergeOf(RefToLine(0, 3, 100, 3), RefToLine(0, 0, 100, 0))});
  ASSERT_EQ(edited.graph.links.size(), 1u);
  EXPECT_NEAR(YOf(edited.graph.links[0], 50), 0.6, 0.01);
}

TEST(MergeEdit, WhatGoesOnBeyondIsAppended) {
  const DrawingGraph graph =
      WithEqualSigmas(GraphOf({DenseLine(0, 0, 100, 0), DenseLine(150, 2, 70, 2)}));
  const EditedDrawing edited =
      Edited(graph, {MergeOf(RefToLine(0, 0, 100, 0), RefToLine(70, 2, 150, 2))});
  ASSERT_EQ(edited.graph.links.size(), 1u);
  const Polyline3d& points = edited.graph.links[0].points_in_world;
  EXPECT_EQ(points.front(), FrontalPoint(0, 0));
  EXPECT_EQ(points.back(), FrontalPoint(150, 2));
  EXPECT_LT(testing::SharpestTurn(points), M_PI / 2);
  EXPECT_NEAR(Length(points), 150 * kFrontalPx, 4 * kFrontalPx);
}

TEST(MergeEdit, BothEndsMayGoOnBeyond) {
  // An arc over its chord: longer than the line, and beyond both of its ends.
  const DrawingGraph graph =
      WithEqualSigmas(GraphOf({DenseLine(0, 0, 100, 0), DenseLine(-40, 3, 60, 3)}));
  const EditedDrawing edited =
      Edited(graph, {MergeOf(RefToLine(0, 0, 100, 0), RefToLine(-40, 3, 60, 3))});
  ASSERT_EQ(edited.graph.links.size(), 1u);
  EXPECT_NEAR(Length(edited.graph.links[0].points_in_world), 140 * kFrontalPx, 5 * kFrontalPx);
}

TEST(MergeEdit, WhatEndedAtTheOtherLinkEndsAtTheMergedOne) {
  const DrawingGraph graph =
      WithEqualSigmas(GraphOf({DenseLine(0, 0, 100, 0), DenseLine(30, 3, 99, 3),
                               DenseLine(30, 3, 30, 60), DenseLine(99, 3, 99, 60)}));
  const EditedDrawing edited =
      Edited(graph, {MergeOf(RefToLine(0, 0, 100, 0), RefToLine(30, 3, 99, 3))});
  // The merged link is cut where the third one ends; the fourth one ends at its end.
  ASSERT_EQ(edited.graph.links.size(), 4u);
  int num_junctions = 0;
  int num_corners = 0;
  for (const DrawingNode& node : edited.graph.nodes) {
    num_junctions += node.Degree() == 3;
    num_corners += node.Degree() == 2;
  }
  EXPECT_EQ(num_junctions, 1);
  EXPECT_EQ(num_corners, 1);
  EXPECT_THAT(edited.touched, ElementsAre(1, 1, 1, 1));
}

TEST(MergeEdit, LinksFromOneCornerKeepIt) {
  const DrawingGraph graph = WithEqualSigmas(
      GraphOf({DenseLine(0, 0, 100, 0), DenseLine(0, 0, 90, 6), DenseLine(0, 0, 0, 50)}));
  const EditedDrawing edited =
      Edited(graph, {MergeOf(RefToLine(0, 0, 100, 0), RefToLine(0, 0, 90, 6))});
  EXPECT_EQ(edited.graph.links.size(), 2u);
  EXPECT_EQ(DegreeAt(edited.graph, FrontalPoint(0, 0)), 2);
}

TEST(MergeEdit, Rings) {
  const DrawingGraph graph = WithEqualSigmas(GraphOf({DenseRing(0, 0, 50), DenseRing(0, 0, 54)}));
  const EditedDrawing edited = Edited(graph, {MergeOf(RefTo(graph.links[0].points_in_world),
                                                      RefTo(graph.links[1].points_in_world))});
  ASSERT_EQ(edited.graph.links.size(), 1u);
  EXPECT_TRUE(edited.graph.links[0].closed);
  EXPECT_NEAR(Length(edited.graph.links[0].points_in_world), 2 * M_PI * 52 * kFrontalPx,
              2 * kFrontalPx);
}

TEST(MergeEdit, LinksThatDoNotRunAlongEachOtherMakeNoSense) {
  const DrawingGraph graph = GraphOf({DenseLine(0, 0, 100, 0), DenseLine(50, 1, 50, 60),
                                      DenseLine(0, 40, 100, 40), DenseLine(110, 0, 180, 0)});
  const LinkRef base = RefToLine(0, 0, 100, 0);
  for (const LinkRef& other :
       {RefToLine(50, 1, 50, 60), RefToLine(0, 40, 100, 40), RefToLine(110, 0, 180, 0)}) {
    EXPECT_EQ(Refused(graph, MergeOf(base, other)).status, EditStatus::kNoSense);
  }
}

TEST(MergeEdit, OneLinkAloneMakesNoSense) {
  const DrawingGraph graph = GraphOf({DenseLine(0, 0, 100, 0)});
  EXPECT_EQ(Refused(graph, MergeOf(RefToLine(0, 0, 100, 0), RefToLine(0, 2, 100, 2))).status,
            EditStatus::kNoSense);
}

}  // namespace
}  // namespace limn
