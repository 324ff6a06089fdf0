// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/long_edges.h"

#include <gtest/gtest.h>

#include "limn/topology/frontal_scene.h"

namespace limn {
namespace {

using testing::ArcFromOrigin;
using testing::FrontalPoint;
using testing::FrontalScene;
using testing::kFrontalPx;
using testing::PxSegment;

LongEdgeCounts AddTo(FrontalScene* scene) {
  return scene->Run([](const auto& input, GraphEditor* editor) {
    return AddLongEdges(input, RunContext(), editor);
  });
}

// Two links along the y axis, from (-50, 0) and from (50, 0), in the views given.
void DrawSides(const std::vector<ViewId>& in_views, FrontalScene* scene) {
  scene->ShowAndDraw(PxSegment(-50, 0, -50, 40), in_views);
  scene->ShowAndDraw(PxSegment(50, 0, 50, 40), in_views);
}

// The images show an edge between their ends, too, in the views given; it is not drawn.
FrontalScene Frame(const std::vector<ViewId>& in_views) {
  FrontalScene scene;
  DrawSides(scene.AllViews(), &scene);
  scene.Show(PxSegment(-50, 0, 50, 0), in_views);
  return scene;
}
FrontalScene Frame() { return Frame(FrontalScene().AllViews()); }

// A link made from the edgels between two places of that edge, but so far away.
void DrawPiece(double begin_px, double end_px, double depth_px, FrontalScene* scene) {
  const Eigen::Vector3d away(0, 0, depth_px * kFrontalPx);
  scene->DrawFromEdgelsOf(PxSegment(begin_px, 0, end_px, 0),
                          {FrontalPoint(begin_px, 0) + away, FrontalPoint(end_px, 0) + away});
}

TEST(AddLongEdgesTest, EdgeBetweenTwoCornersIsDrawn) {
  FrontalScene scene = Frame();
  EXPECT_EQ(AddTo(&scene).added, 1);
  ASSERT_EQ(scene.graph.links.size(), 3u);
  EXPECT_NEAR(scene.LengthPx(2), 100, 1e-6);
  EXPECT_EQ(scene.Degree(-50, 0), 2);
  EXPECT_EQ(scene.Degree(50, 0), 2);
}

TEST(AddLongEdgesTest, ItReplacesPiecesAtWrongDepths) {
  FrontalScene scene = Frame();
  DrawPiece(-40, -10, 8, &scene);
  DrawPiece(-5, 30, -6, &scene);
  const LongEdgeCounts counts = AddTo(&scene);
  EXPECT_EQ(counts.added, 1);
  EXPECT_EQ(counts.replaced, 2);
  EXPECT_EQ(scene.graph.links.size(), 3u);
}

TEST(AddLongEdgesTest, OtherEdgesStay) {
  // One runs beside it, one across, and one goes on beyond its end.
  FrontalScene scene = Frame();
  scene.ShowAndDraw(PxSegment(-30, 8, 30, 8));
  scene.ShowAndDraw(PxSegment(0, 3, 0, 40));
  scene.ShowAndDraw(PxSegment(53, 0, 70, 0));
  const LongEdgeCounts counts = AddTo(&scene);
  EXPECT_EQ(counts.replaced, 0);
  EXPECT_EQ(scene.graph.links.size(), static_cast<size_t>(5 + counts.added));
}

TEST(AddLongEdgesTest, EdgeThatOneLinkDrawsIsDrawn) {
  // All but the ends, at its place or not.
  for (const double depth_px : {0.0, 8.0}) {
    FrontalScene scene = Frame();
    DrawPiece(-40, 40, depth_px, &scene);
    const LongEdgeCounts counts = AddTo(&scene);
    EXPECT_EQ(counts.added, 0);
    EXPECT_EQ(counts.replaced, 0);
  }
}

TEST(AddLongEdgesTest, EnoughViewsMustShowIt) {
  // Of the sixteen views that show the corners.
  const auto added = [](ViewId num_views) {
    FrontalScene scene = Frame(FrontalScene().Views(0, num_views));
    return AddTo(&scene).added;
  };
  EXPECT_EQ(added(7), 0);
  EXPECT_EQ(added(9), 1);
}

TEST(AddLongEdgesTest, ThreeViewsAreTooFew) {
  const auto added = [](const std::vector<ViewId>& views) {
    FrontalScene scene;
    DrawSides(views, &scene);
    scene.Show(PxSegment(-50, 0, 50, 0), views);
    return AddTo(&scene).added;
  };
  EXPECT_EQ(added({0, 5, 10}), 0);
  EXPECT_EQ(added({0, 3, 5, 10}), 1);
}

TEST(AddLongEdgesTest, WhatChanceExplainsIsNotDrawn) {
  FrontalScene scene = Frame();
  for (const double y : {-9, -7, -5, 5, 7, 9}) scene.Show(PxSegment(-60, y, 60, y));
  EXPECT_EQ(AddTo(&scene).added, 0);
}

TEST(AddLongEdgesTest, OnlyStraightEdgesAreDrawn) {
  const auto added = [](double radius_px) {
    FrontalScene scene;
    const testing::PxLine arc = ArcFromOrigin(radius_px, 60 / radius_px);
    const Eigen::Vector2d end = arc.back();
    scene.ShowAndDraw(PxSegment(0, 0, 0, 40));
    scene.ShowAndDraw(PxSegment(end.x(), end.y(), end.x(), end.y() + 40));
    scene.Show(arc);
    return AddTo(&scene).added;
  };
  EXPECT_EQ(added(100), 0);
  EXPECT_EQ(added(2000), 1);
}

TEST(AddLongEdgesTest, ImageCurvesMustRunFromEndToEnd) {
  // Edgels run along seven tenths of it and more, but no curve along all of it.
  FrontalScene scene;
  DrawSides(scene.AllViews(), &scene);
  scene.Show(PxSegment(-50, 0, -5, 0));
  scene.Show(PxSegment(5, 0, 50, 0));
  EXPECT_EQ(AddTo(&scene).added, 0);
}

TEST(AddLongEdgesTest, ImageCurvesMustRunStraight) {
  // The one from end to end makes a detour; those along the edge end before.
  FrontalScene scene;
  DrawSides(scene.AllViews(), &scene);
  scene.Show(PxSegment(-45, 0, -2, 0));
  scene.Show(PxSegment(2, 0, 45, 0));
  testing::PxLine detour = PxSegment(-50, 0, 0, -20);
  const testing::PxLine back = PxSegment(0, -20, 50, 0);
  detour.insert(detour.end(), back.begin() + 1, back.end());
  scene.Show(detour);
  EXPECT_EQ(AddTo(&scene).added, 0);
}

TEST(AddLongEdgesTest, EndsMustBeCertain) {
  // All cameras are in a row along the edge, so that nothing tells the depth of a link along it.
  // Links from its ends to the side do.
  const auto added = [](const std::vector<double>& sides_at) {
    FrontalScene scene(6, 1);
    scene.ShowAndDraw(PxSegment(-70, 0, -50, 0));
    scene.ShowAndDraw(PxSegment(50, 0, 70, 0));
    scene.Show(PxSegment(-50, 0, 50, 0));
    for (const double x : sides_at) scene.ShowAndDraw(PxSegment(x, 0, x, 40));
    return AddTo(&scene).added;
  };
  EXPECT_EQ(added({}), 0);
  EXPECT_EQ(added({-50}), 0);
  EXPECT_EQ(added({50}), 0);
  EXPECT_EQ(added({-50, 50}), 1);
}

TEST(AddLongEdgesTest, TheLongestOfSeveralIsDrawn) {
  // Another link meets the edge halfway; the repair takes it there.
  FrontalScene scene = Frame();
  scene.ShowAndDraw(PxSegment(0, 0, 0, 40));
  EXPECT_EQ(scene.Repair().long_edges.added, 1);
  EXPECT_EQ(scene.Degree(-50, 0), 2);
  EXPECT_EQ(scene.Degree(50, 0), 2);
  EXPECT_EQ(scene.Degree(0, 0), 3);
  EXPECT_EQ(scene.graph.links.size(), 5u);
}

TEST(AddLongEdgesTest, ShortEdgesAreLeftToGrowth) {
  const auto added = [](double length_px) {
    FrontalScene scene;
    scene.ShowAndDraw(PxSegment(0, 0, 0, 40));
    scene.ShowAndDraw(PxSegment(length_px, 0, length_px, 40));
    scene.Show(PxSegment(0, 0, length_px, 0));
    return AddTo(&scene).added;
  };
  EXPECT_EQ(added(18), 0);
  EXPECT_EQ(added(22), 1);
}

TEST(AddLongEdgesTest, NothingIsAddedToAnEmptyDrawing) {
  FrontalScene scene;
  EXPECT_EQ(AddTo(&scene).added, 0);
}

}  // namespace
}  // namespace limn
