// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gtest/gtest.h>

#include "limn/sketch/epipolar_crossings.h"
#include "limn/sketch/sweep_candidates.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using Eigen::Vector3d;

class CrossingsTest : public ::testing::Test {
 protected:
  std::vector<EpipolarCrossing> Find(const std::vector<testing::SceneCurve>& curves, size_t vertex,
                                     double min_inverse_depth = 0.1, double max_inverse_depth = 1) {
    first_ = testing::ProjectCurves(primary_, curves);
    const ImageCurves second = testing::ProjectCurves(second_, curves);
    rays_ = MakeFragmentRays(primary_, first_, 0);
    std::vector<EpipolarCrossing> crossings;
    const FragmentChords chords(second);
    CrossingFinder(primary_, second_, chords)
        .Find(rays_, vertex, {min_inverse_depth, max_inverse_depth}, 3, &crossings);
    return crossings;
  }

  // Those of the same vertex near a place.
  std::vector<EpipolarCrossing> FindNear(const std::vector<testing::SceneCurve>& curves,
                                         size_t vertex, double inverse_depth) {
    const ImageCurves second = testing::ProjectCurves(second_, curves);
    const FragmentChords chords(second);
    const DepthPlace place{static_cast<float>(inverse_depth), 0};
    std::vector<EpipolarCrossing> crossings;
    CrossingFinder(primary_, second_, chords)
        .FindNear(rays_, vertex, {0.1, 1}, {&place, 1}, 3, &crossings);
    return crossings;
  }

  const View primary_ = testing::LookAt({5, 0, 1}, {0, 0, 0});
  const View second_ = testing::LookAt({4.6, 1.9, 1.2}, {0, 0, 0});
  ImageCurves first_;
  FragmentRays rays_;
};

// Inverse depth of the line a + t d, in the camera, on a ray.
double InverseDepth(const Vector3d& a, const Vector3d& d, const Vector3d& ray) {
  const Vector3d normal = d.cross(ray).cross(d);
  return normal.dot(ray) / normal.dot(a);
}

TEST_F(CrossingsTest, DepthAndSlopeOfALineAreExact) {
  const Vector3d from(-0.2, -0.3, -0.7), to(0.3, 0.2, 0.8);
  const Vector3d a = primary_.cam_from_world * from;
  const Vector3d d = (primary_.cam_from_world * to - a).normalized();
  for (const size_t vertex : {20u, 60u, 100u}) {
    const auto crossings = Find({testing::Segment(from, to)}, vertex);
    ASSERT_EQ(crossings.size(), 1u);
    EXPECT_EQ(crossings[0].view, 3);
    const double here = InverseDepth(a, d, rays_.rays[vertex]);
    EXPECT_NEAR(crossings[0].inverse_depth, here, 1e-6 * here);
    const double next = InverseDepth(a, d, rays_.rays[vertex + 1]);
    const double step_px = rays_.arc_px[vertex + 1] - rays_.arc_px[vertex];
    EXPECT_NEAR(crossings[0].slope_per_px, (next - here) / step_px, 1e-3 * here / step_px);
  }
}

TEST_F(CrossingsTest, ToleranceSaysWhatAPixelDoesToDepth) {
  // The same line twice, the second moved: the change of inverse depth divided by the tolerance is
  // its distance in the second view, px.
  const Vector3d from(0, 0, -0.7), to(0, 0, 0.7), moved(0.02, 0, 0);
  const auto crossings =
      Find({testing::Segment(from, to), testing::Segment(from + moved, to + moved)}, 50);
  ASSERT_EQ(crossings.size(), 2u);
  const auto distance_px = [&](const View& view, const Vector3d& offset) {
    const auto a = view.Project(offset), b = view.Project(offset + Vector3d(0, 0, 0.01));
    const auto here = view.Project(Vector3d::Zero());
    const Eigen::Vector2d along = (*b - *a).normalized();
    return std::abs(along.x() * (here->y() - a->y()) - along.y() * (here->x() - a->x()));
  };
  const double px = std::abs(crossings[1].inverse_depth - crossings[0].inverse_depth) *
                    crossings[0].across_px_per_inverse_depth;
  EXPECT_NEAR(px, distance_px(second_, moved), 0.05 * px);
}

TEST_F(CrossingsTest, NoneLeavesTheRange) {
  const auto line = testing::Segment({0, 0, -0.7}, {0, 0, 0.7});
  EXPECT_EQ(Find({line}, 50, 0.15, 0.25).size(), 1u);
  EXPECT_TRUE(Find({line}, 50, 0.25, 0.5).empty());
  EXPECT_TRUE(Find({line}, 50, 0.05, 0.15).empty());
}

TEST_F(CrossingsTest, NearAPlaceOnTheLine) {
  const auto line = testing::Segment({0, 0, -0.7}, {0, 0, 0.7});
  const auto all = Find({line}, 50);
  ASSERT_EQ(all.size(), 1u);
  const double px = 1 / all[0].px_per_inverse_depth;
  const double within = (CrossingFinder::kNearPx - 1) * px,
               beyond = (CrossingFinder::kNearPx + 2) * px;
  for (const double side : {-1, 1}) {
    const auto near = FindNear({line}, 50, all[0].inverse_depth + side * within);
    ASSERT_EQ(near.size(), 1u);
    EXPECT_EQ(near[0].inverse_depth, all[0].inverse_depth);
    EXPECT_TRUE(FindNear({line}, 50, all[0].inverse_depth + side * beyond).empty());
  }
}

std::vector<DepthMode> Elect(const std::vector<EpipolarCrossing>& crossings) {
  return DepthElection(600, SketchOptions()).Find(crossings);
}

EpipolarCrossing MakeCrossing(int view, float inverse_depth, float slope_per_px, float sine = 1) {
  EpipolarCrossing crossing;
  crossing.view = view;
  crossing.inverse_depth = inverse_depth;
  crossing.slope_per_px = slope_per_px;
  crossing.px_per_inverse_depth = 1000;
  crossing.across_px_per_inverse_depth = 1000 * sine;
  crossing.rad_per_slope = crossing.across_px_per_inverse_depth;
  return crossing;
}

TEST(AgreeingDepthsTest, EveryViewVotesOnce) {
  // Two views agree near 0.2; near 0.3 one view sees three curves.
  const auto modes =
      Elect({MakeCrossing(0, 0.2, 0), MakeCrossing(1, 0.3, 0), MakeCrossing(1, 0.3003, 0),
             MakeCrossing(1, 0.3005, 0), MakeCrossing(2, 0.2006, 0)});
  ASSERT_EQ(modes.size(), 1u);
  EXPECT_NEAR(modes[0].depth.inverse_depth, 0.2003, 1e-7);
}

TEST(AgreeingDepthsTest, DirectionsMustAgreeToo) {
  const float turned = 0.4f / 1000;  // 0.4 radians
  EXPECT_TRUE(Elect({MakeCrossing(0, 0.2, 0), MakeCrossing(1, 0.2, turned)}).empty());
}

TEST(AgreeingDepthsTest, MeanIsWeightedByInformation) {
  const auto modes = Elect({MakeCrossing(0, 0.2, 0), MakeCrossing(1, 0.201, 0, 0.5)});
  ASSERT_EQ(modes.size(), 1u);
  EXPECT_NEAR(modes[0].depth.inverse_depth, (0.2 + 0.25 * 0.201) / 1.25, 1e-7);
}

TEST(AgreeingDepthsTest, BestSupportedDepthComesFirst) {
  std::vector<EpipolarCrossing> crossings;
  for (const int view : {0, 1}) crossings.push_back(MakeCrossing(view, 0.2, 0));
  for (const int view : {0, 1, 2, 3}) crossings.push_back(MakeCrossing(view, 0.3, 0));
  std::sort(crossings.begin(), crossings.end(),
            [](const auto& a, const auto& b) { return a.view < b.view; });
  const auto modes = Elect(crossings);
  ASSERT_EQ(modes.size(), 2u);
  EXPECT_NEAR(modes[0].depth.inverse_depth, 0.3, 1e-7);
  EXPECT_NEAR(modes[1].depth.inverse_depth, 0.2, 1e-7);
  EXPECT_TRUE(Elect({}).empty());
}

TEST(AgreeingDepthsTest, OnlyWhatIsProposedIsElected) {
  std::vector<EpipolarCrossing> crossings;
  for (const int view : {0, 1, 2}) {
    for (const float depth : {0.2f, 0.3f, 0.4f}) crossings.push_back(MakeCrossing(view, depth, 0));
  }
  crossings.push_back(MakeCrossing(3, 0.3f, 0));
  DepthElection election(600, SketchOptions());
  EXPECT_EQ(election.Find(crossings).size(), 3u);
  const std::vector<DepthPlace> proposals = {{0.2005f, 0}, {0.3005f, 0}, {0.25f, 0}};
  const auto modes = election.FindNear(crossings, proposals);
  ASSERT_EQ(modes.size(), 2u);
  EXPECT_NEAR(modes[0].depth.inverse_depth, 0.3, 1e-7);
  EXPECT_NEAR(modes[1].depth.inverse_depth, 0.2, 1e-7);
  EXPECT_TRUE(election.FindNear(crossings, {}).empty());
}

}  // namespace
}  // namespace limn
