// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <gtest/gtest.h>

#include "limn/topology/frontal_scene.h"

namespace limn {
namespace {

using testing::FrontalScene;

// Of all points of a link.
double LargestX(const FrontalScene& scene, LinkId link) {
  double largest = -1e9;
  for (const Eigen::Vector3d& point : scene.graph.links[link].points_in_world) {
    largest = std::max(largest, point.x() / testing::kFrontalPx);
  }
  return largest;
}

// A link that ends at (0, 0), and one that begins at (-20, gap_px) and runs along it from there.
FrontalScene Overlapping(double gap_px) {
  FrontalScene scene;
  scene.Draw({{-60, 0}, {0, 0}});
  scene.Draw({{-20, gap_px}, {60, gap_px}});
  return scene;
}

TEST(TrimEndsTest, EndThatRunsBesideALinkIsCutBackToWhereThatBegins) {
  FrontalScene scene = Overlapping(0.9);
  EXPECT_EQ(scene.Trim(), 1);
  ASSERT_EQ(scene.graph.links.size(), 2u);
  // To a point or two.
  EXPECT_NEAR(LargestX(scene, 0), -21, 1.5);
  EXPECT_NEAR(scene.LengthPx(1), 80, 1e-6);
  EXPECT_EQ(scene.graph.links[0].sigma.size(), scene.graph.links[0].points_in_world.size());
}

TEST(TrimEndsTest, EndFartherAsideStays) {
  FrontalScene scene = Overlapping(1.1);
  EXPECT_EQ(scene.Trim(), 0);
  EXPECT_NEAR(scene.LengthPx(0), 60, 1e-6);
  EXPECT_NEAR(scene.LengthPx(1), 80, 1e-6);
}

TEST(TrimEndsTest, EitherEndIsCut) {
  FrontalScene scene;
  scene.Draw({{0, 0}, {-60, 0}});
  scene.Draw({{-20, 0.5}, {60, 0.5}});
  EXPECT_EQ(scene.Trim(), 1);
  EXPECT_LT(LargestX(scene, 0), -19);
  // And both of one link.
  FrontalScene both;
  both.Draw({{-60, 0}, {60, 0}});
  both.Draw({{-80, 0.5}, {-40, 0.5}, {-40, 40}});
  both.Draw({{80, 0.5}, {40, 0.5}, {40, 40}});
  EXPECT_EQ(both.Trim(), 2);
  EXPECT_NEAR(both.LengthPx(0), 80, 4);
}

TEST(TrimEndsTest, LinksThatPartAreNotBesideEachOther) {
  // From a point of the first link the second leaves at an angle.
  const auto trimmed = [](double angle_rad) {
    FrontalScene scene;
    scene.Draw({{-60, 0}, {60, 0}});
    scene.Draw(testing::Ray({0, 0.5}, angle_rad, 60));
    return scene.Trim();
  };
  EXPECT_EQ(trimmed(0.42), 1);
  EXPECT_EQ(trimmed(0.46), 0);
  EXPECT_EQ(trimmed(M_PI - 0.42), 1);  // whatever their directions
}

TEST(TrimEndsTest, AngleIsAnOption) {
  const auto trimmed = [](double min_junction_angle_deg) {
    FrontalScene scene;
    scene.options.min_junction_angle_deg = min_junction_angle_deg;
    scene.Draw({{-60, 0}, {60, 0}});
    scene.Draw(testing::Ray({0, 0.5}, 0.7, 60));  // 40.1 degrees
    return scene.Trim();
  };
  EXPECT_EQ(trimmed(39), 0);
  EXPECT_EQ(trimmed(41), 1);
}

TEST(TrimEndsTest, LinkOfWhichLittleIsLeftGoes) {
  // It runs along the first one for 20 px and then leaves it.
  const auto with_rest = [](double rest_px) {
    FrontalScene scene;
    scene.Draw({{-60, 0}, {60, 0}});
    scene.Draw({{0, 0.5}, {20, 0.5}, {20, 0.5 + rest_px}});
    EXPECT_EQ(scene.Trim(), 1);
    return scene;
  };
  EXPECT_EQ(with_rest(4).graph.links.size(), 1u);
  EXPECT_EQ(with_rest(4).graph.nodes.size(), 2u);
  const FrontalScene scene = with_rest(8);
  ASSERT_EQ(scene.graph.links.size(), 2u);
  EXPECT_NEAR(scene.LengthPx(1), 8, 1);
}

TEST(TrimEndsTest, OfTwoLinksOnOneAnotherOneStays) {
  FrontalScene scene;
  scene.Draw({{-30, 0}, {30, 0}});
  scene.Draw({{30, 0.5}, {-30, 0.5}});
  EXPECT_GE(scene.Trim(), 1);
  ASSERT_EQ(scene.graph.links.size(), 1u);
  EXPECT_NEAR(scene.LengthPx(0), 60, 1e-6);
}

TEST(TrimEndsTest, EndsAtNodesStay) {
  // Two links leave one node side by side.
  FrontalScene scene;
  scene.Draw({{0, 0}, {60, 0}});
  scene.Draw({{0, 0}, {30, 1}, {30, 40}});
  EXPECT_EQ(scene.Trim(), 0);
  EXPECT_EQ(scene.Degree(0, 0), 2);
}

TEST(TrimEndsTest, EndsThatRunAlongALoopAreCutAndTheLoopStays) {
  FrontalScene scene;
  scene.Draw(testing::RingThroughOrigin(60));
  // Touches the ring, from far outside.
  scene.Draw({{-60, -0.5}, {2, -0.5}});
  EXPECT_EQ(scene.Trim(), 1);
  ASSERT_EQ(scene.graph.links.size(), 2u);
  EXPECT_TRUE(scene.graph.links[0].closed);
  EXPECT_NEAR(scene.LengthPx(0), 120 * M_PI, 0.5);
  EXPECT_LT(LargestX(scene, 1), 0);
}

TEST(TrimEndsTest, FrozenLinksAreLeftAlone) {
  FrontalScene scene = Overlapping(0.5);
  scene.Freeze(0);
  scene.Freeze(1);
  scene.Draw({{0, 80}, {60, 80}});
  EXPECT_EQ(scene.Trim(), 0);
  EXPECT_EQ(scene.graph.links[0].points_in_world, testing::InWorld({{-60, 0}, {0, 0}}));
  EXPECT_EQ(scene.graph.links[1].points_in_world, testing::InWorld({{-20, 0.5}, {60, 0.5}}));
}

}  // namespace
}  // namespace limn
