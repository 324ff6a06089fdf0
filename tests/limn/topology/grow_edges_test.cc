// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/grow_edges.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/topology/frontal_scene.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// One end of what grows is where its joint is; the other is right to what a step of growth and the
// gate along edgels leave open.
constexpr double kGrownEndPx = 2.5;

using testing::FrontalPoint;
using testing::FrontalScene;
using testing::kFrontalPx;
using testing::PxSegment;

double LengthPx(const Polyline3d& line) { return Length(line) / kFrontalPx; }

// Whether it is one straight line from the origin to (x, y).
void ExpectGrownTo(const std::vector<Polyline3d>& grown, double x_px, double y_px,
                   double max_px = kGrownEndPx) {
  ASSERT_EQ(grown.size(), 1u);
  EXPECT_LT(grown[0].front().norm(), 1e-9);
  EXPECT_LT((grown[0].back() - FrontalPoint(x_px, y_px)).norm() / kFrontalPx, max_px)
      << grown[0].back().transpose() / kFrontalPx;
}

// The link from the origin along the x axis is drawn, and the images show an edge along the y axis
// too, in the views given.
FrontalScene Corner(double length_px, const std::vector<ViewId>& in_views) {
  FrontalScene scene;
  scene.ShowAndDraw(PxSegment(0, 0, 60, 0));
  scene.Show(PxSegment(0, 0, 0, length_px), in_views);
  return scene;
}
FrontalScene Corner(double length_px) { return Corner(length_px, FrontalScene().AllViews()); }

TEST(GrowEdgesTest, MissingEdgeGrowsToItsEndAndNotBeyond) {
  for (const double length_px : {8.0, 20.0, 40.0, 70.0}) {
    FrontalScene scene = Corner(length_px);
    ExpectGrownTo(scene.Grow(), 0, length_px);
    EXPECT_EQ(scene.Degree(0, 0), 2);
  }
}

TEST(GrowEdgesTest, DirectionFollowsTheEdge) {
  // From a joint beside the edge, the first pixels point across it.
  FrontalScene scene;
  scene.ShowAndDraw(PxSegment(0, 0, 60, 0));
  scene.Show(PxSegment(1, 0, 1, 60));
  ExpectGrownTo(scene.Grow(), 1, 60);
}

TEST(GrowEdgesTest, EdgeInDepthGrowsToo) {
  FrontalScene scene;
  scene.ShowAndDraw(PxSegment(0, 0, 60, 0));
  const Eigen::Vector3d end = FrontalPoint(0, 40) + Eigen::Vector3d(0, 0, 20 * kFrontalPx);
  scene.ShowInSpace({FrontalPoint(0, 0), end});
  const auto grown = scene.Grow();
  ASSERT_EQ(grown.size(), 1u);
  // Across the line of sight the end is as certain as on the plane, along it less: at this base a
  // pixel sideways is three in depth.
  EXPECT_LT((grown[0].back() - end).norm() / kFrontalPx, 3 * kGrownEndPx);
}

TEST(GrowEdgesTest, NothingGrowsWhereNothingIsMissing) {
  FrontalScene scene;
  scene.ShowAndDraw(PxSegment(0, 0, 60, 0));
  scene.ShowAndDraw(PxSegment(0, 0, 0, 40));
  EXPECT_TRUE(scene.Grow().empty());
}

TEST(GrowEdgesTest, SeveralEdgesGrowFromOneCorner) {
  FrontalScene scene = Corner(40);
  scene.Show(PxSegment(0, 0, -30, -30));
  EXPECT_EQ(scene.Grow().size(), 2u);
  EXPECT_EQ(scene.Degree(0, 0), 3);
}

TEST(GrowEdgesTest, ShortGapsAreBridgedAndLongOnesNot) {
  const auto grown = [](double gap_px) {
    FrontalScene scene;
    scene.ShowAndDraw(PxSegment(0, 0, 60, 0));
    scene.Show(PxSegment(0, 0, 0, 30));
    scene.Show(PxSegment(0, 30 + gap_px, 0, 60));
    return scene.Grow();
  };
  ExpectGrownTo(grown(3), 0, 60);
  ExpectGrownTo(grown(10), 0, 30);
}

TEST(GrowEdgesTest, HalfOfTheViewsMustShowIt) {
  // All views show 30 px of it, some 60.
  const auto grown = [](ViewId num_long) {
    FrontalScene scene = Corner(30);
    scene.Show(PxSegment(0, 30, 0, 60), scene.Views(0, num_long));
    return scene.Grow();
  };
  ExpectGrownTo(grown(7), 0, 30);
  ExpectGrownTo(grown(9), 0, 60);
}

TEST(GrowEdgesTest, GrowthStopsAtTheBox) {
  FrontalScene scene = Corner(40);
  Eigen::AlignedBox3d box(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 20.5 * kFrontalPx, 1));
  const auto grown = scene.Grow(box);
  ExpectGrownTo(grown, 0, 20, 1);
  EXPECT_TRUE(box.contains(grown.at(0).back()));
}

TEST(GrowEdgesTest, EdgeEndsAtAJointThatItReaches) {
  // Another link begins near the end of the edge.
  const auto grow = [](double x_px, double y_px, FrontalScene* scene) {
    *scene = Corner(40);
    scene->ShowAndDraw(PxSegment(x_px, y_px, x_px - 60, y_px));
    return scene->Grow();
  };
  FrontalScene scene;
  ExpectGrownTo(grow(0, 42, &scene), 0, 42, 1e-6);
  EXPECT_EQ(scene.Degree(0, 42), 2);
  EXPECT_EQ(scene.Degree(0, 0), 2);
  ExpectGrownTo(grow(-1.5, 41, &scene), -1.5, 41, 1e-6);
  EXPECT_EQ(scene.Degree(-1.5, 41), 2);
  // Out of reach: beside its line, and beyond its end.
  ExpectGrownTo(grow(-3, 41, &scene), 0, 40);
  EXPECT_EQ(scene.Degree(-3, 41), 1);
  ExpectGrownTo(grow(0, 50, &scene), 0, 40);
  EXPECT_EQ(scene.Degree(0, 50), 1);
}

TEST(GrowEdgesTest, OnlyToJointsIfAskedTo) {
  FrontalScene scene = Corner(40);
  EXPECT_TRUE(scene.Grow({}, GrowthEnd::kJoint).empty());
  scene = Corner(40);
  scene.ShowAndDraw(PxSegment(0, 42, -60, 42));
  ExpectGrownTo(scene.Grow({}, GrowthEnd::kJoint), 0, 42, 1e-6);
}

TEST(GrowEdgesTest, NothingGrowsAlongALinkThatIsThere) {
  // A second edge leaves the corner at this angle from the one that is drawn.
  const auto num_grown = [](double angle_deg) {
    FrontalScene scene;
    scene.ShowAndDraw(PxSegment(0, 0, 60, 0));
    const double angle = angle_deg * kDeg;
    scene.Show(PxSegment(0, 0, 40 * std::cos(angle), 40 * std::sin(angle)));
    return scene.Grow().size();
  };
  EXPECT_EQ(num_grown(14), 0u);
  EXPECT_EQ(num_grown(32), 1u);
}

TEST(GrowEdgesTest, SomeEdgelsMustBeNobodysYet) {
  // The edge ends at the corner, and a link elsewhere was made from all its edgels.
  FrontalScene scene = Corner(40);
  scene.DrawFromEdgelsOf(PxSegment(0, 0, 0, 40),
                         {FrontalPoint(100, 0) - Eigen::Vector3d(0, 0, 0.3),
                          FrontalPoint(100, 40) - Eigen::Vector3d(0, 0, 0.3)});
  EXPECT_TRUE(scene.Grow().empty());
}

TEST(GrowEdgesTest, ViewsThatSeeTheCornerMustBeEnough) {
  // Only views that show a link at the corner are asked.
  const auto num_grown = [](const std::vector<ViewId>& see_corner,
                            const std::vector<ViewId>& see_edge) {
    FrontalScene scene;
    scene.ShowAndDraw(PxSegment(0, 0, 60, 0), see_corner);
    scene.Show(PxSegment(0, 0, 0, 40), see_edge);
    return scene.Grow().size();
  };
  const std::vector<ViewId> all = FrontalScene().AllViews();
  EXPECT_EQ(num_grown({0, 2, 5, 7}, all), 1u);
  EXPECT_EQ(num_grown({0, 2, 7}, all), 0u);
  EXPECT_EQ(num_grown(all, {0, 2, 5, 7}), 1u);
  EXPECT_EQ(num_grown(all, {0, 2, 7}), 0u);
}

TEST(GrowEdgesTest, WhatChanceExplainsDoesNotGrow) {
  // Edges beside it, as in a texture.
  FrontalScene scene = Corner(40);
  for (const double x : {-9, -7, -5, 5, 7, 9}) scene.Show(PxSegment(x, -20, x, 60));
  EXPECT_TRUE(scene.Grow().empty());
  // One of them is no texture.
  FrontalScene one = Corner(40);
  one.Show(PxSegment(7, -20, 7, 60));
  ExpectGrownTo(one.Grow(), 0, 40);
}

// Links that end at the origin and begin `gap_px` to its right, and the images show an edge between
// them in the views given.
FrontalScene Gap(double gap_px, const std::vector<ViewId>& in_views) {
  FrontalScene scene;
  scene.ShowAndDraw(PxSegment(0, -60, 0, 0));
  scene.ShowAndDraw(PxSegment(gap_px, 0, gap_px, 60));
  scene.Show(PxSegment(0, 0, gap_px, 0), in_views);
  return scene;
}
FrontalScene Gap(double gap_px) { return Gap(gap_px, FrontalScene().AllViews()); }

TEST(AddShortEdgesTest, EdgeBetweenTwoJointsIsAdded) {
  FrontalScene scene = Gap(12);
  const auto added = scene.AddShort();
  ASSERT_EQ(added.size(), 1u);
  EXPECT_NEAR(LengthPx(added[0]), 12, 1e-6);
  EXPECT_EQ(scene.Degree(0, 0), 2);
  EXPECT_EQ(scene.Degree(12, 0), 2);
}

TEST(AddShortEdgesTest, LongestIsAnOption) {
  const auto num_added = [](double gap_px, double max_short_edge_px) {
    FrontalScene scene = Gap(gap_px);
    scene.options.max_short_edge_px = max_short_edge_px;
    return scene.AddShort().size();
  };
  EXPECT_EQ(num_added(29, 30), 1u);
  EXPECT_EQ(num_added(31, 30), 0u);
  EXPECT_EQ(num_added(31, 40), 1u);
  EXPECT_EQ(num_added(12, 10), 0u);
  EXPECT_EQ(num_added(12, 0), 0u);
  // What is shorter than 3 px is one joint.
  EXPECT_EQ(num_added(2.5, 30), 0u);
}

TEST(AddShortEdgesTest, EnoughViewsMustShowIt) {
  EXPECT_EQ(Gap(12, {0, 2, 5, 7}).AddShort().size(), 1u);
  EXPECT_EQ(Gap(12, {0, 2, 7}).AddShort().size(), 0u);
  EXPECT_EQ(Gap(12, {}).AddShort().size(), 0u);
}

TEST(AddShortEdgesTest, OnlyViewsThatSeeBothJointsAreAsked) {
  const auto num_added = [](ViewId end_of_first) {
    FrontalScene scene;
    scene.ShowAndDraw(PxSegment(0, -60, 0, 0), scene.Views(0, end_of_first));
    scene.ShowAndDraw(PxSegment(12, 0, 12, 60), scene.Views(5, 16));
    scene.Show(PxSegment(0, 0, 12, 0));
    return scene.AddShort().size();
  };
  EXPECT_EQ(num_added(9), 1u);
  EXPECT_EQ(num_added(8), 0u);
}

TEST(AddShortEdgesTest, DirectionsThatAreTakenAreNot) {
  // A third link leaves the joint on the left, at this angle from the short edge.
  const auto num_added = [](double angle_deg) {
    FrontalScene scene = Gap(12);
    const double angle = angle_deg * kDeg;
    scene.Draw(PxSegment(0, 0, 60 * std::cos(angle), 60 * std::sin(angle)));
    return scene.AddShort().size();
  };
  EXPECT_EQ(num_added(-18), 0u);
  EXPECT_EQ(num_added(-23), 1u);
}

TEST(AddShortEdgesTest, NoEdgeTwice) {
  // Three joints in a row, with an edge from the first to the last.
  FrontalScene scene = Gap(24);
  scene.ShowAndDraw(PxSegment(12, 0, 12, -60));
  double length_px = 0;
  for (const Polyline3d& added : scene.AddShort()) length_px += LengthPx(added);
  EXPECT_NEAR(length_px, 24, 1e-6);
}

TEST(AddShortEdgesTest, SomeEdgelsMustBeNobodysYet) {
  FrontalScene scene = Gap(12);
  scene.DrawFromEdgelsOf(PxSegment(0, 0, 12, 0),
                         {FrontalPoint(100, 0) - Eigen::Vector3d(0, 0, 0.3),
                          FrontalPoint(112, 0) - Eigen::Vector3d(0, 0, 0.3)});
  EXPECT_TRUE(scene.AddShort().empty());
}

TEST(AddShortEdgesTest, WhatChanceExplainsIsNotAdded) {
  FrontalScene scene = Gap(12);
  for (const double y : {-9, -7, -5, 5, 7, 9}) scene.Show(PxSegment(-20, y, 40, y));
  EXPECT_TRUE(scene.AddShort().empty());
}

}  // namespace
}  // namespace limn
