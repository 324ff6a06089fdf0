// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/build_sketch.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "limn/sketch/sketched_cube.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

SketchResult RunSketch(SketchMode mode, int num_threads = 2,
                       std::optional<Eigen::AlignedBox3d> box = std::nullopt) {
  RunContext context;
  context.num_threads = num_threads;
  return BuildSketch(mode, {{testing::CubeViews(), testing::CubeCurves(), kNoHints, box}},
                     SketchOptions(), context);
}

// The two sketches that judge sample by sample.
class BuildSketchTest : public ::testing::TestWithParam<SketchMode> {
 protected:
  static SketchResult Build(int num_threads = 2,
                            std::optional<Eigen::AlignedBox3d> box = std::nullopt) {
    return RunSketch(GetParam(), num_threads, box);
  }
};

INSTANTIATE_TEST_SUITE_P(Modes, BuildSketchTest,
                         ::testing::Values(SketchMode::kEnhanced, SketchMode::kSweep));

TEST_P(BuildSketchTest, FindsTheCubePreciselyInSoundCurves) {
  const SketchResult result = Build();
  testing::ExpectSoundCube(result.sketch);
  const TauResult row = testing::EvaluateCube(result.sketch, 1);
  EXPECT_GE(row.recall.value(), 0.97);
  EXPECT_GE(row.precision.value(), 0.95);
}

TEST_P(BuildSketchTest, FatesTellWhichEdgelsAreInCurves) {
  const SketchResult result = Build();
  EdgelFates expected;
  for (size_t v = 0; v < testing::CubeCurves().size(); ++v) {
    ASSERT_EQ(result.fates.at(v).size(), testing::CubeCurves()[v].edge_map.edgels.size());
    expected.emplace_back(result.fates[v].size(), EdgelFate::kNotLinked);
  }
  for (const Curve3D& curve : result.sketch.curves) {
    const auto& ids =
        testing::CubeCurves().at(curve.anchor.view).fragments.at(curve.anchor.fragment).edgel_ids;
    // Between samples, too, and up to the next one behind the last.
    const size_t num_vertices = curve.anchor.step * curve.size();
    for (size_t k = 0; k < std::min(num_vertices, ids.size()); ++k) {
      const EdgelId id = ids[(curve.anchor.begin + k) % ids.size()];
      const bool is_behind = k > curve.anchor.step * (curve.size() - 1);
      expected[curve.anchor.view][id] =
          is_behind ? result.fates[curve.anchor.view][id] : EdgelFate::kSketched;
    }
  }
  for (size_t v = 0; v < expected.size(); ++v) {
    for (size_t id = 0; id < expected[v].size(); ++id) {
      EXPECT_EQ(result.fates[v][id] == EdgelFate::kSketched,
                expected[v][id] == EdgelFate::kSketched);
    }
  }
}

TEST_P(BuildSketchTest, ReconstructsOnlyInsideTheBox) {
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-2, -2, 0.1), Eigen::Vector3d(2, 2, 2));
  const CurveSketch sketch = Build(2, box).sketch;
  ASSERT_FALSE(sketch.curves.empty());
  // Samples between two inside are inside too; fitting may move them by a fraction of a pixel.
  for (const Curve3D& curve : sketch.curves) {
    for (const Eigen::Vector3d& point : curve.points_in_world) EXPECT_GT(point.z(), 0.1 - 0.01);
  }
}

// More views than whose support is held at once; the last ones by themselves are fewer.
TEST_P(BuildSketchTest, ViewsInSeveralBlocksMakeWhatTheyMakeInOne) {
  const auto views = testing::DomeViews(70, 5);
  const auto curves =
      testing::ProjectCurves(views, {testing::Segment({-0.8, -0.3, 0.1}, {0.7, 0.4, -0.2})});
  SketchInput input = {{views, curves}};
  SketchOptions options;
  options.view_selection.enough_primary_views = 70;
  const CurveSketch all = BuildSketch(GetParam(), input, options, {}).sketch;
  input.only = {62, 63, 64, 65, 66, 67, 68, 69};
  const CurveSketch last = BuildSketch(GetParam(), input, options, {}).sketch;
  ASSERT_GE(last.curves.size(), input.only->size());
  ASSERT_GE(all.curves.size(), last.curves.size());
  const auto first = all.curves.end() - static_cast<std::ptrdiff_t>(last.curves.size());
  EXPECT_LT((first - 1)->anchor.view, 62);
  EXPECT_TRUE(std::equal(
      last.curves.begin(), last.curves.end(), first, [](const Curve3D& a, const Curve3D& b) {
        return a.anchor.view == b.anchor.view && a.points_in_world == b.points_in_world &&
               a.support.edgels == b.support.edgels;
      }));
}

TEST_P(BuildSketchTest, SomeOfManyViewsOfOnePlaceAreSketched) {
  const auto views = testing::DomeViews(60, 5);
  const auto curves =
      testing::ProjectCurves(views, {testing::Segment({-0.8, -0.3, 0.1}, {0.7, 0.4, -0.2})});
  SketchOptions options;
  options.view_selection.enough_primary_views = 10;
  const SketchResult result = BuildSketch(GetParam(), {{views, curves}}, options, {});
  std::set<ViewId> sketched;
  for (const Curve3D& curve : result.sketch.curves) sketched.insert(curve.anchor.view);
  EXPECT_GE(sketched.size(), 8u);
  EXPECT_LE(sketched.size(), 30u);
  int64_t num_edgels = 0;
  int64_t num_not_sketched = 0;
  for (ViewId v = 0; v < 60; ++v) {
    for (const EdgelFate fate : result.fates[v]) {
      ++num_edgels;
      num_not_sketched += fate == EdgelFate::kNotSketched;
      EXPECT_TRUE(fate != EdgelFate::kNotSketched || !sketched.contains(v));
    }
  }
  EXPECT_GT(num_not_sketched, num_edgels / 2);
  const StageSummary& summary = result.summary;
  EXPECT_EQ(summary.in[1].second, num_edgels);
  int64_t accounted = summary.kept[0].second;
  for (const auto& [reason, count] : summary.dropped) accounted += count;
  EXPECT_EQ(accounted, num_edgels);
}

// Powers of two change no digit.
TEST_P(BuildSketchTest, TheUnitOfLengthDoesNotMatter) {
  const CurveSketch in_meters = Build().sketch;
  for (const double factor : {std::ldexp(1, -44), std::ldexp(1, 27), std::ldexp(1, 40)}) {
    const std::vector<View> views = testing::Scaled(testing::CubeViews(), factor);
    const CurveSketch sketch =
        BuildSketch(GetParam(), {{views, testing::CubeCurves()}}, SketchOptions(), {}).sketch;
    ASSERT_EQ(sketch.curves.size(), in_meters.curves.size()) << factor;
    for (size_t c = 0; c < sketch.curves.size(); ++c) {
      const Curve3D& curve = sketch.curves[c];
      ASSERT_EQ(curve.size(), in_meters.curves[c].size()) << factor;
      for (size_t s = 0; s < curve.size(); ++s) {
        const Eigen::Vector3d& point = in_meters.curves[c].points_in_world[s];
        EXPECT_LT((curve.points_in_world[s] / factor - point).norm(), 1e-6) << factor;
      }
    }
  }
}

TEST_P(BuildSketchTest, ThreadsDoNotMatter) {
  const CurveSketch one = Build(1).sketch;
  const CurveSketch two = Build(2).sketch;
  ASSERT_EQ(one.curves.size(), two.curves.size());
  for (size_t c = 0; c < one.curves.size(); ++c) {
    EXPECT_EQ(one.curves[c].points_in_world, two.curves[c].points_in_world);
    EXPECT_EQ(one.curves[c].support.edgels, two.curves[c].support.edgels);
  }
}

}  // namespace
}  // namespace limn
