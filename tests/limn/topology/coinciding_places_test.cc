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
  EXPECT_EQ(scene.Unite().crossings, 3);
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
  EXPECT_EQ(crossings(5), 1);
  EXPECT_EQ(crossings(3), 0);
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
  FrontalScene ends = corner_and(Ray({0, 0}, -0.25 * M_PI, 40));  // at the node itself
  EXPECT_EQ(ends.Unite().passed, 0);
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

// A link passes through a corner, and across one of its arms 4.5 px from it. On the link both places
// are nearer than 4 px, hence one; as one node they would make a loop of the arm.
TEST(CoincidingPlacesTest, NoLoopsOfAFewPx) {
  FrontalScene scene;
  constexpr double kTurnRad = 2.8;
  PxLine arm = testing::ArcFromOrigin(1.6, kTurnRad);
  const Eigen::Vector2d across = arm.back();
  arm.push_back(across + 40 * Unit(kTurnRad));
  scene.ShowAndDraw(arm);
  scene.ShowAndDraw(Ray({0, 0}, 0, 40));
  scene.ShowAndDraw(Through(kTurnRad / 2));
  const CoincidenceCounts counts = scene.Unite();
  EXPECT_EQ(counts.crossings, 1);
  EXPECT_EQ(counts.passed, 1);
  for (const DrawingLink& link : scene.graph.links) EXPECT_NE(link.node0, link.node1);
}

}  // namespace
}  // namespace limn
