// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/original_sketch.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "limn/sketch/sketched_cube.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

const SketchResult& Original() {
  static const SketchResult result =
      BuildOriginalSketch({{testing::CubeViews(), testing::CubeCurves()}}, SketchOptions(), {});
  return result;
}

// Circumference of 80 px in frontal views, seen without rotation: one fragment, whose first vertex
// is in the middle of an arc that crosses the horizontal epipolar lines.
testing::SceneCurve Ring() { return testing::Circle({0, 0, 0}, 40 / M_PI * testing::kFrontalPx); }

TEST(OriginalSketchTest, CurvesAreSound) { testing::ExpectSoundCube(Original().sketch); }

// A depth comes from edgels with a standard deviation of 0.2 px, divided by the sines of two
// angles: it is never better known than 0.2 footprints.
TEST(OriginalSketchTest, DepthsAreKnownNoBetterThanEdgels) {
  for (const Curve3D& curve : Original().sketch.curves) {
    const View& view = testing::CubeViews().at(curve.anchor.view);
    for (size_t s = 0; s < curve.size(); ++s) {
      const double depth = (view.cam_from_world * curve.points_in_world[s]).z();
      ASSERT_GE(curve.depth_sigma[s], 0.199 * depth / view.camera.MeanFocal());
    }
  }
}

TEST(OriginalSketchTest, FindsMostOfTheCube) {
  EXPECT_GE(testing::EvaluateCube(Original().sketch, 2).recall.value(), 0.8);
}

// Two curves in line that the linker took for one in the first view, and for two in all others:
// every half is matched by itself.
TEST(OriginalSketchTest, StretchesOfAFragmentThatMatchDifferentCurvesDoNotCompete) {
  std::vector<ImageCurves> curves = testing::ProjectCurves(
      testing::CubeViews(), {testing::Segment({-0.8, -0.3, 0.1}, {-0.1, -0.05, 0.0}),
                             testing::Segment({0.1, 0.02, -0.03}, {0.8, 0.27, -0.13})});
  std::vector<CurveFragment>& fragments = curves[0].fragments;
  const int half = static_cast<int>(fragments[0].edgel_ids.size());
  const std::vector<EdgelId> second_half = fragments[1].edgel_ids;
  fragments[0].edgel_ids.insert(fragments[0].edgel_ids.end(), second_half.begin(),
                                second_half.end());
  fragments.resize(1);
  const CurveSketch sketch =
      BuildOriginalSketch({{testing::CubeViews(), curves}}, SketchOptions(), {}).sketch;
  int num_first = 0;
  int num_second = 0;
  for (const Curve3D& curve : sketch.curves) {
    if (curve.anchor.view == 0) ++(curve.anchor.begin < half ? num_first : num_second);
  }
  EXPECT_GE(num_first, 5);
  EXPECT_EQ(num_first, num_second);
}

TEST(OriginalSketchTest, AllPairsOfViewsAreMatchedOnRequest) {
  SketchOptions options;
  const auto num_pairs = [&] {
    const SketchResult result =
        BuildOriginalSketch({{testing::CubeViews(), testing::CubeCurves()}}, options, {});
    return result.summary.in.at(0).second;
  };
  EXPECT_LE(num_pairs(), 16 * options.view_selection.max_second_views);
  options.original_exhaustive_pairs = true;
  EXPECT_EQ(num_pairs(), 16 * 15);
}

TEST(OriginalSketchTest, CurvesKnowTheirTotalSupport) {
  SketchOptions options;
  for (const Curve3D& curve : Original().sketch.curves) {
    ASSERT_GE(curve.total_support, options.original_min_inliers_total);
    // At most every sample in every confirmation view.
    ASSERT_LE(curve.total_support, static_cast<double>(curve.size()) * 14);
  }
}

// A curve that every view sees along 60 px. Two views confirm a pair of four, three one of five.
TEST(OriginalSketchTest, FewViewsNeedLessTotalSupport) {
  for (const int num_views : {4, 5}) {
    const auto views = testing::FrontalViews(num_views, 1, 0.4);
    const auto curves = testing::ProjectCurves(
        views, {testing::Segment(testing::FrontalPoint(0, -30), testing::FrontalPoint(10, 30))});
    SketchOptions options;
    const auto num_curves = [&] {
      const CurveSketch sketch = BuildOriginalSketch({{views, curves}}, options, {}).sketch;
      for (const Curve3D& curve : sketch.curves) {
        EXPECT_GE(curve.total_support, options.original_min_inliers_total / 5.0 * (num_views - 2));
      }
      return static_cast<int>(sketch.curves.size());
    };
    EXPECT_EQ(num_curves(), num_views * (num_views - 1)) << num_views;
    options.original_min_inliers_total = 330;  // more than 60 in each view
    EXPECT_EQ(num_curves(), 0) << num_views;
  }
}

// 7 times 22 px are more than 125, but less than 7 times 25.
TEST(OriginalSketchTest, ManyViewsNeedNoMoreTotalSupport) {
  const auto views = testing::FrontalViews(9, 1, 0.25);
  const auto curves = testing::ProjectCurves(
      views, {testing::Segment(testing::FrontalPoint(0, -11), testing::FrontalPoint(3, 11))});
  const CurveSketch sketch = BuildOriginalSketch({{views, curves}}, SketchOptions(), {}).sketch;
  EXPECT_GE(sketch.curves.size(), 9u);
}

// Each half of the ring is a curve, though one passes the first vertex of the fragment.
TEST(OriginalSketchTest, CurvesOfAClosedFragmentPassItsFirstVertex) {
  const auto views = testing::FrontalViews(9, 1, 0.4);
  const auto curves = testing::ProjectCurves(views, {Ring()});
  const CurveSketch sketch = BuildOriginalSketch({{views, curves}}, SketchOptions(), {}).sketch;
  size_t num_passing = 0;
  for (const Curve3D& curve : sketch.curves) {
    const View& view = views.at(curve.anchor.view);
    const ImageCurves& image = curves.at(curve.anchor.view);
    const auto& ids = image.fragments.at(0).edgel_ids;
    ASSERT_FALSE(curve.closed);
    ASSERT_GE(curve.anchor.begin, 0);
    ASSERT_LT(curve.anchor.begin, static_cast<int>(ids.size()));
    num_passing += curve.anchor.begin + curve.size() > ids.size();
    for (size_t s = 0; s < curve.size(); ++s) {
      const Edgel& edgel = image.edge_map.edgels[ids[(curve.anchor.begin + s) % ids.size()]];
      EXPECT_LT((view.Project(curve.points_in_world[s]).value() - edgel.position_px).norm(), 1e-6);
      EXPECT_LT(std::abs(curve.points_in_world[s].z()), 0.05);
    }
  }
  EXPECT_GE(num_passing, 9u);
  EXPECT_EQ(sketch.curves.size(), 2 * num_passing);
}

}  // namespace
}  // namespace limn
