// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/epipolar_stretches.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

// Circumference of 80 px in frontal views, seen without rotation: one fragment, whose first vertex
// is in the middle of an arc that crosses the horizontal epipolar lines.
testing::SceneCurve Ring() { return testing::Circle({0, 0, 0}, 40 / M_PI * testing::kFrontalPx); }

// Epipolar lines are horizontal.
TEST(EpipolarStretchesTest, AreCutWhereTheCurveTurnsBackOrRunsAlongTheLines) {
  const auto views = testing::FrontalViews(2, 1, 0.6);
  const testing::SceneCurve roof{{testing::FrontalPoint(-90, 0), testing::FrontalPoint(-30, 60),
                                  testing::FrontalPoint(30, 60), testing::FrontalPoint(90, 0)},
                                 false};
  const testing::SceneCurve tip{
      {testing::FrontalPoint(-60, 0), testing::FrontalPoint(0, 60), testing::FrontalPoint(30, 30)},
      false};
  const auto curves = testing::ProjectCurves(views, {roof, tip});
  const auto stretches = [&](int fragment, double min_length_px) {
    return EpipolarStretches(MakeFragmentRays(views[0], curves[0], fragment), views[0], views[1],
                             std::sin(0.2), min_length_px);
  };
  const auto of_roof = stretches(0, 20);
  ASSERT_EQ(of_roof.size(), 2u);
  EXPECT_GT(of_roof[1].begin - of_roof[0].end, 50);
  const auto of_tip = stretches(1, 20);
  ASSERT_EQ(of_tip.size(), 2u);
  EXPECT_LE(of_tip[1].begin - of_tip[0].end, 2);
  EXPECT_EQ(stretches(1, 60).size(), 1u);
}

TEST(EpipolarStretchesTest, OfAClosedFragmentPassItsFirstVertex) {
  const auto views = testing::FrontalViews(2, 1, 0.6);
  const ImageCurves curves = testing::ProjectCurves(views[0], {Ring()});
  FragmentRays ring = MakeFragmentRays(views[0], curves, 0);
  const int size = static_cast<int>(ring.size());
  ASSERT_EQ(size, 80);
  const auto stretches = [&] {
    return EpipolarStretches(ring, views[0], views[1], std::sin(0.2), 20);
  };
  const auto of_ring = stretches();
  ASSERT_EQ(of_ring.size(), 2u);
  EXPECT_LE(of_ring[0].end, size);
  EXPECT_LT(of_ring[1].begin, size);
  EXPECT_GT(of_ring[1].end, size);
  for (const VertexStretch& stretch : of_ring) {
    const FragmentRays open = OpenStretch(ring, stretch.begin, stretch.end);
    EXPECT_FALSE(open.closed);
    ASSERT_EQ(static_cast<int>(open.size()), stretch.end - stretch.begin);
    EXPECT_NEAR(open.arc_px.back() - open.arc_px.front(), 35, 2);
    for (size_t i = 1; i < open.size(); ++i) {
      EXPECT_NEAR(open.arc_px[i] - open.arc_px[i - 1], 1, 0.01);
      EXPECT_NEAR((open.positions_px[i] - open.positions_px[i - 1]).norm(), 1, 0.01);
    }
  }
  ring.closed = false;  // the second half falls into two that are too short
  EXPECT_EQ(stretches().size(), 1u);
}

}  // namespace
}  // namespace limn
