// SPDX-License-Identifier: BSD-3-Clause
#include "limn/belief/link_claims.h"

#include <gtest/gtest.h>

#include "limn/belief/belief_scene.h"

namespace limn {
namespace {

using testing::BeliefScene;
using testing::FrontalPoint;
using testing::Segment;

// A link so far above the plane that only some views see it within the gate of the same edge.
Polyline3d Above(double height) {
  return {FrontalPoint(-50, 0) + Eigen::Vector3d(0, 0, height),
          FrontalPoint(50, 0) + Eigen::Vector3d(0, 0, height)};
}

TEST(FindClaimsTest, EdgelsBelongToTheLinkThatMoreViewsShow) {
  for (const bool edge_first : {true, false}) {
    BeliefScene scene;
    scene.Show(Segment(FrontalPoint(-60, 0), FrontalPoint(60, 0)));
    const Polyline3d edge = {FrontalPoint(-60, 0), FrontalPoint(60, 0)};
    const LinkId first = scene.Draw(edge_first ? edge : Above(0.15));
    const LinkId second = scene.Draw(edge_first ? Above(0.15) : edge);
    const auto found = scene.Evidence();
    const ImageEvidence& of_edge = found[edge_first ? first : second];
    const ImageEvidence& of_other = found[edge_first ? second : first];
    // The rows of views at 0.15 and 0.45 beside the edge: a height of 0.15 moves it by 0.6 and 1.8
    // px.
    EXPECT_EQ(of_edge.showing_views, 16);
    EXPECT_EQ(of_other.showing_views, 8);
    EXPECT_EQ(of_edge.OwnShare(), 1);
    EXPECT_EQ(of_other.OwnShare(), 0);
  }
}

TEST(FindClaimsTest, CrossingLinksKeepTheirEdgels) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0));
  scene.Add(FrontalPoint(0, -50), FrontalPoint(0, 50));
  for (const ImageEvidence& link : scene.Evidence()) EXPECT_EQ(link.OwnShare(), 1);
}

TEST(FindClaimsTest, EdgesSideBySideKeepTheirEdgels) {
  BeliefScene scene;
  scene.Add(FrontalPoint(-50, 0), FrontalPoint(50, 0));
  scene.Add(FrontalPoint(-50, 4), FrontalPoint(50, 4));
  for (const ImageEvidence& link : scene.Evidence()) EXPECT_EQ(link.OwnShare(), 1);
}

TEST(FindClaimsTest, ALinkWithoutEdgelsLacksNone) {
  BeliefScene scene;
  scene.Draw({FrontalPoint(-50, 0), FrontalPoint(50, 0)});
  EXPECT_EQ(scene.Evidence()[0].OwnShare(), 1);
}

}  // namespace
}  // namespace limn
