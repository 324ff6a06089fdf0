// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/continue_curves.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "limn/topology/frontal_scene.h"
#include "support/random_numbers.h"

namespace limn {
namespace {

using testing::FrontalScene;
using testing::PxLine;
using testing::PxSegment;

// Edgels support places up to this far along them, and are a px apart.
constexpr double kEndPx = 1.5;

ContinuationCounts Continue(FrontalScene* scene,
                            const std::optional<Eigen::AlignedBox3d>& box = std::nullopt) {
  return scene->Run([&](TopologyInput input, GraphEditor* editor) {
    input.box = box;
    return ContinueCurves(input, scene->options, {}, editor);
  });
}

// The largest and the smallest of the coordinates of all points, px.
Eigen::AlignedBox3d ExtentPx(const DrawingGraph& graph) {
  Eigen::AlignedBox3d extent;
  for (const DrawingLink& link : graph.links) {
    for (const Eigen::Vector3d& point : link.points_in_world) {
      extent.extend(Eigen::Vector3d(point / testing::kFrontalPx));
    }
  }
  return extent;
}

// How far a link that is drawn from x = -60 to 0 goes when the images show this much of its line.
double EndOfLine(FrontalScene* scene) {
  scene->Show(PxSegment(-60, 0, 0, 0));
  scene->Draw(PxSegment(-60, 0, 0, 0));
  Continue(scene);
  const Eigen::AlignedBox3d extent = ExtentPx(scene->graph);
  EXPECT_NEAR(extent.min().x(), -60, kEndPx);
  return extent.max().x();
}

TEST(ContinueCurvesTest, NothingIsDoneToNothing) {
  FrontalScene scene;
  EXPECT_EQ(Continue(&scene).ends, 0);
}

TEST(ContinueCurvesTest, LinkGoesOnToTheEndOfItsEdge) {
  FrontalScene scene;
  scene.Show(PxSegment(-60, 0, 60, 0));
  scene.Draw(PxSegment(-60, 0, 0, 0));
  const ContinuationCounts counts = Continue(&scene);
  EXPECT_EQ(counts.ends, 1);
  EXPECT_NEAR(counts.length_px, 60, kEndPx);
  ASSERT_EQ(scene.graph.links.size(), 1u);
  const Eigen::AlignedBox3d extent = ExtentPx(scene.graph);
  EXPECT_NEAR(extent.max().x(), 60, kEndPx);
  EXPECT_NEAR(extent.min().x(), -60, kEndPx);
  EXPECT_LT(extent.sizes().tail<2>().maxCoeff(), 0.1);
  for (const LinkVertex& vertex : scene.graph.links[0].vertices) {
    EXPECT_EQ(vertex.support.size(), scene.views().size());
  }
}

TEST(ContinueCurvesTest, BothEndsGoOn) {
  FrontalScene scene;
  scene.Show(PxSegment(-60, 0, 60, 0));
  scene.Draw(PxSegment(-20, 0, 20, 0));
  EXPECT_EQ(Continue(&scene).ends, 2);
  EXPECT_NEAR(scene.TotalPx(), 120, 2 * kEndPx);
}

TEST(ContinueCurvesTest, LinkThatEndsWithItsEdgeStays) {
  FrontalScene scene;
  scene.ShowAndDraw(PxSegment(-60, 0, 60, 0));
  Continue(&scene);
  EXPECT_NEAR(scene.TotalPx(), 120, 2 * kEndPx);
}

TEST(ContinueCurvesTest, GapsArePassedUpToTheLimit) {
  const auto end = [](double gap_px, double max_gap_px) {
    FrontalScene scene;
    scene.options.max_continuation_gap_px = max_gap_px;
    scene.Show(PxSegment(0, 0, 30, 0));
    scene.Show(PxSegment(30 + gap_px, 0, 80, 0));
    return EndOfLine(&scene);
  };
  EXPECT_NEAR(end(5, 6), 80, kEndPx);
  EXPECT_NEAR(end(10, 6), 30, kEndPx);
  // Edgels support places a px before and after them.
  EXPECT_NEAR(end(5, 1), 30, kEndPx);
}

TEST(ContinueCurvesTest, BendsAreFollowed) {
  for (const double radius : {12.0, 16.0, 20.0, 25.0, 30.0}) {
    FrontalScene scene;
    scene.Show(testing::ArcFromOrigin(radius, M_PI));
    scene.Draw(testing::ArcFromOrigin(radius, M_PI / 2));
    const ContinuationCounts counts = Continue(&scene);
    EXPECT_NEAR(counts.length_px, radius * M_PI / 2, kEndPx + 0.02 * radius);
    for (const Eigen::Vector3d& point : scene.graph.links[0].points_in_world) {
      const Eigen::Vector3d center(0, radius, 0);
      EXPECT_NEAR((point / testing::kFrontalPx - center).norm(), radius, 0.5);
    }
  }
}

TEST(ContinueCurvesTest, CornersAreNot) {
  FrontalScene scene;
  scene.Show(PxSegment(20, 0, 20, 60));
  scene.Show(PxSegment(0, 0, 20, 0));
  EXPECT_NEAR(EndOfLine(&scene), 20, kEndPx);
  EXPECT_LT(ExtentPx(scene.graph).max().y(), 1);
}

TEST(ContinueCurvesTest, ThreeViewsMustShowIt) {
  const auto end = [](ViewId num_views) {
    FrontalScene scene;
    scene.Show(PxSegment(-60, 0, 60, 0), scene.Views(0, num_views));
    scene.Draw(PxSegment(-60, 0, 0, 0), scene.Views(0, num_views));
    Continue(&scene);
    return ExtentPx(scene.graph).max().x();
  };
  EXPECT_NEAR(end(2), 0, kEndPx);
  EXPECT_NEAR(end(4), 60, kEndPx);
}

TEST(ContinueCurvesTest, EnoughOfTheViewsMustShowIt) {
  // The link is seen in all 16 views, what lies beyond it in three.
  FrontalScene scene;
  scene.Show(PxSegment(0, 0, 60, 0), scene.Views(0, 3));
  EXPECT_NEAR(EndOfLine(&scene), 0, kEndPx);
}

TEST(ContinueCurvesTest, EdgelsThatLinksHaveAreNoReason) {
  const auto length_px = [](bool taken) {
    FrontalScene scene;
    scene.Show(PxSegment(-60, 0, 60, 0));
    scene.Draw(PxSegment(-60, 0, 0, 0));
    const PxLine elsewhere = PxSegment(0, -50, 60, -50);
    if (taken) scene.DrawFromEdgelsOf(PxSegment(0, 0, 60, 0), testing::InWorld(elsewhere));
    Continue(&scene);
    return scene.LengthPx(0);
  };
  EXPECT_NEAR(length_px(false), 120, kEndPx);
  EXPECT_NEAR(length_px(true), 60, kEndPx);
}

TEST(ContinueCurvesTest, FacingEndsMeetAndDoNotOverlap) {
  FrontalScene scene;
  scene.Show(PxSegment(-60, 0, 60, 0));
  scene.Draw(PxSegment(-60, 0, -25, 0));
  scene.Draw(PxSegment(25, 0, 60, 0));
  const ContinuationCounts counts = Continue(&scene);
  EXPECT_EQ(scene.graph.links.size(), 2u);
  // A step beyond which the link is that runs on.
  EXPECT_NEAR(counts.length_px, 50, 2);
  EXPECT_NEAR(scene.TotalPx(), 120, 2 * kEndPx + 2);
}

TEST(ContinueCurvesTest, LinkStopsWhereItComesUponAnother) {
  // Whose end is fixed by a corner.
  FrontalScene scene;
  scene.Show(PxSegment(-60, 0, 60, 0));
  scene.Show(PxSegment(30, 0, 30, 50));
  scene.Draw(PxSegment(-60, 0, 0, 0));
  scene.Draw(PxSegment(30, 0, 60, 0));
  scene.Draw(PxSegment(30, 0, 30, 50));
  const double total_px = 60 + 30 + 50;
  const ContinuationCounts counts = Continue(&scene);
  EXPECT_EQ(counts.ends, 1);
  EXPECT_NEAR(counts.length_px, 30, 2);
  EXPECT_NEAR(scene.TotalPx(), total_px + 30, 2);
}

TEST(ContinueCurvesTest, LinksAreCrossed) {
  FrontalScene scene;
  scene.Show(PxSegment(0, 0, 60, 0));
  scene.ShowAndDraw(PxSegment(30, -40, 30, 40));
  EXPECT_NEAR(EndOfLine(&scene), 60, kEndPx);
}

TEST(ContinueCurvesTest, RingIsNotFollowedTwice) {
  FrontalScene scene;
  scene.Show(testing::RingThroughOrigin(20));
  scene.Draw(testing::ArcFromOrigin(20, M_PI));
  Continue(&scene);
  EXPECT_EQ(scene.graph.links.size(), 1u);
  EXPECT_NEAR(scene.TotalPx(), 40 * M_PI, 4);
}

TEST(ContinueCurvesTest, LinksDoNotLeaveTheBox) {
  FrontalScene scene;
  scene.Show(PxSegment(-60, 0, 60, 0));
  scene.Draw(PxSegment(-60, 0, 0, 0));
  const Eigen::Vector3d corner(25 * testing::kFrontalPx, 1, 1);
  Continue(&scene, Eigen::AlignedBox3d(Eigen::Vector3d(-1, -1, -1), corner));
  const double end = ExtentPx(scene.graph).max().x();
  EXPECT_LE(end, 25);
  EXPECT_GT(end, 25 - kEndPx);
}

TEST(ContinueCurvesTest, LinksWithoutVerticesStay) {
  FrontalScene scene;
  scene.Show(PxSegment(-60, 0, 60, 0));
  const LinkId link = scene.Draw(PxSegment(-60, 0, 0, 0));
  scene.Freeze(link);
  EXPECT_EQ(Continue(&scene).ends, 0);
  EXPECT_NEAR(scene.TotalPx(), 60, 1e-9);
}

TEST(ContinueCurvesTest, HatchingShowsNoLine) {
  // Wherever a copy of the line is put, there are edgels along it.
  FrontalScene scene;
  for (int y = -14; y <= 14; y += 2) scene.Show(PxSegment(2, y, 60, y));
  EXPECT_NEAR(EndOfLine(&scene), 0, 2 + kEndPx);
}

TEST(ContinueCurvesTest, ClutterShowsNoLine) {
  // Beyond the ends, views show short edges of any place and direction.
  constexpr int kNumScenes = 10;
  double added_px = 0;
  for (unsigned seed = 0; seed < kNumScenes; ++seed) {
    std::mt19937 random(seed);
    testing::UniformDistribution<double> uniform(-1, 1);
    FrontalScene scene;
    for (const ViewId view : scene.AllViews()) {
      for (int i = 0; i < 120; ++i) {
        const Eigen::Vector2d middle(32 + 30 * uniform(random), 15 * uniform(random));
        const Eigen::Vector2d half = 3 * testing::Unit(M_PI * uniform(random));
        scene.Show({middle - half, middle + half}, {view});
      }
    }
    added_px += EndOfLine(&scene);
  }
  // A stretch of 16 px is there by chance at most once in a hundred times.
  EXPECT_LT(added_px, kNumScenes * kEndPx);
}

}  // namespace
}  // namespace limn
