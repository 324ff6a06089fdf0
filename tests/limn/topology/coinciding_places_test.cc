// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/coinciding_places.h"

#include <gtest/gtest.h>

#include "limn/topology/frontal_scene.h"

namespace limn {
namespace {

using testing::FrontalScene;
using testing::InWorld;
using testing::PxLine;
using testing::Ray;
using testing::Unit;

// A straight line whose middle is the origin.
PxLine Through(double angle_rad, double half_px = 40) {
  return {-half_px * Unit(angle_rad), half_px * Unit(angle_rad)};
}

TEST(CoincidingPlacesTest, LinksThatCrossMeet) {
  FrontalScene scene;
  scene.ShowAndDraw(Through(0));
  scene.ShowAndDraw(Through(1.2));
  const CoincidenceCounts counts = scene.Unite();
  EXPECT_EQ(counts.crossings, 1);
  EXPECT_EQ(counts.passed + counts.nodes, 0);
  ASSERT_EQ(scene.graph.links.size(), 4u);
  EXPECT_EQ(scene.graph.nodes.size(), 5u);
  EXPECT_EQ(scene.Degree(0, 0), 4);
  EXPECT_NEAR(scene.TotalPx(), 160, 1e-6);
  // Both go on.
  EXPECT_EQ(testing::Continuations(scene.Node(0, 0)),
            (std::set<std::pair<LinkEnd, LinkEnd>>{{{0, 1}, {3, 0}}, {{1, 1}, {2, 0}}}));
  EXPECT_EQ(scene.Unite().crossings, 0);
}

TEST(CoincidingPlacesTest, ThreeLinksMakeOneNode) {
  FrontalScene scene;
  for (const double angle_rad : {0.0, 1.0, 2.0}) scene.ShowAndDraw(Through(angle_rad));
  EXPECT_EQ(scene.Unite().crossings, 2);
  EXPECT_EQ(scene.graph.links.size(), 6u);
  EXPECT_EQ(scene.Degree(0, 0), 6);
}

TEST(CoincidingPlacesTest, LinksThatCrossTwiceMeetTwice) {
  FrontalScene scene;
  scene.ShowAndDraw({{-40, 0}, {40, 0}});
  scene.ShowAndDraw({{-30, -20}, {0, 20}, {30, -20}});
  EXPECT_EQ(scene.Unite().crossings, 2);
  EXPECT_EQ(scene.Degree(-15, 0, 0.6), 4);
  EXPECT_EQ(scene.Degree(15, 0, 0.6), 4);
}

// What passes at another depth crosses in images only.
TEST(CoincidingPlacesTest, LinksMeetInSpace) {
  const auto crossings = [](double height_px) {
    FrontalScene scene;
    scene.ShowAndDraw(Through(0));
    scene.Show(Through(1.5));
    Polyline3d above = InWorld(Through(1.5));
    for (Eigen::Vector3d& point : above) point.z() += height_px * testing::kFrontalPx;
    scene.DrawFromEdgelsOf(Through(1.5), above);
    return scene.Unite().crossings;
  };
  EXPECT_EQ(crossings(0.9), 1);
  EXPECT_EQ(crossings(1.1), 0);
}

TEST(CoincidingPlacesTest, LinksPart) {
  const auto crossings = [](double angle_rad) {
    FrontalScene scene;
    scene.ShowAndDraw(Through(0));
    scene.ShowAndDraw(Through(angle_rad));
    return scene.Unite().crossings;
  };
  EXPECT_EQ(crossings(0.46), 1);
  EXPECT_EQ(crossings(M_PI - 0.46), 1);
  EXPECT_EQ(crossings(0.42), 0);
}

TEST(CoincidingPlacesTest, LinksGoOn) {
  const auto crossings = [](double beyond_px) {
    FrontalScene scene;
    scene.ShowAndDraw(Through(0));
    scene.ShowAndDraw(Ray({0, -beyond_px}, M_PI / 2, 60));
    return scene.Unite().crossings;
  };
  EXPECT_EQ(crossings(4), 1);
  EXPECT_EQ(crossings(2), 0);
}

// Wherever the points of the links are.
TEST(CoincidingPlacesTest, PointsNeedNotCoincide) {
  for (const double phase_px : {0.0, 0.25, 0.5, 0.75}) {
    FrontalScene scene;
    scene.ShowAndDraw({{-40 + phase_px, 0}, {40 + phase_px, 0}});
    Polyline3d above = InWorld({{0, -40.5}, {0, 39.5}});
    for (Eigen::Vector3d& point : above) point.z() += 0.9 * testing::kFrontalPx;
    scene.Show({{0, -40}, {0, 40}});
    scene.DrawFromEdgelsOf({{0, -40}, {0, 40}}, above);
    EXPECT_EQ(scene.Unite().crossings, 1) << phase_px;
  }
}

// A doubled edge crosses another one once; no link leaves beside another.
TEST(CoincidingPlacesTest, AllLinksOfANodePart) {
  FrontalScene scene;
  scene.ShowAndDraw(Through(0));
  scene.ShowAndDraw(Through(0.2));
  scene.ShowAndDraw(Through(1.2));
  EXPECT_EQ(scene.Unite().crossings, 1);
  EXPECT_EQ(scene.graph.links.size(), 5u);
}

// Three links around a triangle of 2 px: two of its corners are too near on a link.
TEST(CoincidingPlacesTest, NoLinksOfAFewPx) {
  FrontalScene scene;
  scene.ShowAndDraw(Through(0));
  scene.ShowAndDraw(Ray(-40 * Unit(M_PI / 3), M_PI / 3, 80));
  scene.ShowAndDraw(Ray(Eigen::Vector2d(2, 0) - 40 * Unit(2 * M_PI / 3), 2 * M_PI / 3, 80));
  EXPECT_EQ(scene.Unite().crossings, 1);
  for (LinkId id = 0; id < static_cast<LinkId>(scene.graph.links.size()); ++id) {
    EXPECT_GT(scene.LengthPx(id), 30);
    const Polyline3d& points = scene.graph.links[id].points_in_world;
    for (size_t k = 1; k < points.size(); ++k) {
      EXPECT_GT((points[k] - points[k - 1]).norm(), 0.1 * testing::kFrontalPx);
    }
  }
}

TEST(CoincidingPlacesTest, ImagesShowBoth) {
  const auto crossings = [](const std::vector<ViewId>& in_views) {
    FrontalScene scene;
    scene.ShowAndDraw(Through(0));
    scene.Show(Through(1.2), in_views);
    scene.Draw(Through(1.2));
    return scene.Unite().crossings;
  };
  EXPECT_EQ(crossings({0, 1, 2}), 1);
  EXPECT_EQ(crossings({0, 1}), 0);
}

TEST(CoincidingPlacesTest, ALinkPassesThroughACorner) {
  const auto corner_and = [](const PxLine& passing) {
    FrontalScene scene;
    scene.ShowAndDraw({{-40, 0}, {0, 0}});
    scene.ShowAndDraw({{0, 0}, {0, 40}});
    scene.ShowAndDraw(passing);
    return scene;
  };
  FrontalScene scene = corner_and(Through(0.75 * M_PI));
  EXPECT_EQ(scene.Unite().passed, 1);
  EXPECT_EQ(scene.Degree(0, 0), 4);
  FrontalScene along = corner_and(Through(0.9 * M_PI));
  EXPECT_EQ(along.Unite().passed, 0);
}

TEST(CoincidingPlacesTest, TwoCornersAreOneNode) {
  const auto corners = [](double apart_px) {
    FrontalScene scene;
    scene.ShowAndDraw({{-40, 0}, {0, 0}});
    scene.ShowAndDraw({{0, 0}, {0, 40}});
    scene.ShowAndDraw({{40 + apart_px, 0}, {apart_px, 0}});
    scene.ShowAndDraw({{apart_px, 0}, {apart_px, -40}});
    return scene;
  };
  FrontalScene scene = corners(0.8);
  EXPECT_EQ(scene.Unite().nodes, 1);
  EXPECT_EQ(scene.Degree(0.4, 0), 4);
  EXPECT_EQ(corners(1.2).Unite().nodes, 0);
}

// A link passes through a corner, and across one of its arms 3.6 px from it. On the link both
// places are nearer than 3 px: the first one counts.
TEST(CoincidingPlacesTest, NoLoopsOfAFewPx) {
  FrontalScene scene;
  constexpr double kTurnRad = 3;
  PxLine arm = testing::ArcFromOrigin(1.2, kTurnRad);
  arm.push_back(arm.back() + 40 * Unit(kTurnRad));
  scene.ShowAndDraw(arm);
  scene.ShowAndDraw(Ray({0, 0}, 0, 40));
  scene.ShowAndDraw(Through(kTurnRad / 2));
  const CoincidenceCounts counts = scene.Unite();
  EXPECT_EQ(counts.crossings + counts.passed, 1);
  for (const DrawingLink& link : scene.graph.links) EXPECT_NE(link.node0, link.node1);
}

}  // namespace
}  // namespace limn
