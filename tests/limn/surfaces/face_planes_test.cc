// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/face_planes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "limn/model/drawing_transform.h"
#include "limn/topology/graph_fixture.h"
#include "support/face_drawing.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::DrawLink;
using testing::FrontalPoint;
using testing::kFrontalPx;

std::vector<FacePlane> PlanesOf(const DrawingGraph& graph, const std::vector<View>& views) {
  const SurfaceOptions options;
  return FindFacePlanes(MeasureFaceLinks(graph, views, options), graph, options, {});
}

TEST(FacePlanes, ACubeHasSix) {
  const DrawingGraph cube = testing::UnitCube();
  const std::vector<FacePlane> planes = PlanesOf(cube, testing::DomeViews(12, 5));
  ASSERT_EQ(planes.size(), 6u);
  for (const FacePlane& plane : planes) {
    EXPECT_EQ(plane.members.size(), 4u);
    EXPECT_NEAR(plane.normal.cwiseAbs().maxCoeff(), 1, 1e-9);
    EXPECT_NEAR(plane.offset * plane.normal.sum(), std::round(plane.offset * plane.normal.sum()),
                1e-9);
  }
}

// Coordinates of a national grid, where squares of coordinates have no digits left.
TEST(FacePlanes, FarFromTheOrigin) {
  const Eigen::Vector3d far(5e5, 5.4e6, 300);
  const DrawingGraph cube = Transformed(testing::UnitCube(), 1, Eigen::Matrix3d::Identity(), far);
  std::vector<View> views = testing::DomeViews(12, 5);
  for (View& view : views) {
    view.cam_from_world.translation -= view.cam_from_world.rotation * far;
  }
  const std::vector<FacePlane> planes = PlanesOf(cube, views);
  ASSERT_EQ(planes.size(), 6u);
  for (const FacePlane& plane : planes) EXPECT_NEAR(plane.normal.cwiseAbs().maxCoeff(), 1, 1e-7);
}

TEST(FacePlanes, LinksOffThePlaneAreLeftOut) {
  // The sides of a square, 60 px; the last one is lifted at one end.
  for (const double lift_px : {1.0, 12.0}) {
    DrawingGraph graph;
    const auto corner = [](double x, double y) { return FrontalPoint(x, y); };
    DrawLink({corner(-30, -30), corner(30, -30)}, {}, &graph);
    DrawLink({corner(30, -30), corner(30, 30)}, {}, &graph);
    DrawLink({corner(30, 30), corner(-30, 30)}, {}, &graph);
    const Eigen::Vector3d lifted = corner(-30, 30) + Eigen::Vector3d(0, 0, lift_px * kFrontalPx);
    DrawLink({lifted, corner(-30, -30)}, {}, &graph);
    const auto planes = PlanesOf(graph, testing::FrontalViews(4, 4, 0.3));
    ASSERT_FALSE(planes.empty());
    EXPECT_EQ(planes.front().members.size(), lift_px < 2 ? 4u : 3u);
  }
}

// Two squares on a table, far from each other.
TEST(FacePlanes, WhatIsApartInAPlaneIsInItToo) {
  DrawingGraph graph;
  for (const double x : {-150.0, 120.0}) {
    const auto corner = [&](int k) {
      return FrontalPoint(x + (k % 4 == 1 || k % 4 == 2 ? 30 : 0), k % 4 < 2 ? 0 : 30);
    };
    for (int k = 0; k < 4; ++k) DrawLink({corner(k), corner(k + 1)}, {}, &graph);
  }
  const auto planes = PlanesOf(graph, testing::FrontalViews(4, 4, 0.3));
  ASSERT_EQ(planes.size(), 1u);
  EXPECT_EQ(planes[0].members, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
}

TEST(FacePlanes, AFlatClosedLinkIsEnough) {
  DrawingGraph graph;
  Polyline3d ring;
  for (int i = 0; i <= 40; ++i) {
    const double angle = 2 * M_PI * (i % 40) / 40;
    ring.push_back(FrontalPoint(30 * std::cos(angle), 30 * std::sin(angle)));
  }
  DrawLink(ring, {}, &graph);
  const auto views = testing::FrontalViews(4, 4, 0.3);
  ASSERT_EQ(PlanesOf(graph, views).size(), 1u);
  EXPECT_NEAR(std::abs(PlanesOf(graph, views)[0].normal.z()), 1, 1e-9);
  // Half of it bounds nothing.
  DrawingGraph half;
  DrawLink({ring.begin(), ring.begin() + 21}, {}, &half);
  EXPECT_TRUE(PlanesOf(half, views).empty());
}

TEST(FacePlanes, TentativeLinksAndOutlinesBoundNothing) {
  for (const bool tentative : {true, false}) {
    DrawingGraph cube = testing::UnitCube();
    cube.faces.clear();
    for (DrawingLink& link : cube.links) {
      link.tentative = tentative;
      if (!tentative) link.kind = LinkKind::kContour;
    }
    EXPECT_TRUE(PlanesOf(cube, testing::DomeViews(12, 5)).empty());
  }
}

}  // namespace
}  // namespace limn
