#include "limn/pipeline/build_sketch.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "limn/evaluation/evaluate_curves.h"
#include "limn/paper/epipolar_stretches.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr double kHalfSide = 0.8;

const std::vector<View>& Views() {
  static const std::vector<View> views = testing::DomeViews(16, 5);
  return views;
}

const std::vector<ImageCurves>& Curves() {
  static const std::vector<ImageCurves> curves =
      testing::ProjectCurves(Views(), testing::CubeEdges(kHalfSide));
  return curves;
}

SketchResult RunSketch(SketchMode mode, int num_threads = 2,
                       std::optional<Eigen::AlignedBox3d> box = std::nullopt) {
  static const SceneHints no_hints;
  RunContext context;
  context.num_threads = num_threads;
  return BuildSketch(mode, {Views(), Curves(), no_hints, box}, SketchOptions(), context);
}

const SketchResult& Original() {
  static const SketchResult result = RunSketch(SketchMode::kOriginal);
  return result;
}

TauResult Evaluate(const CurveSketch& sketch, double tau) {
  CurveSet truth;
  truth.polylines = testing::Polylines(testing::CubeEdges(kHalfSide));
  EvaluationOptions options;
  options.taus = {tau};
  options.find_duplicates = false;
  const TauResult row =
      EvaluateCurvesInFootprints(ToCurveSet(sketch), truth, Views(), options).rows.at(0);
  ::testing::Test::RecordProperty("recall", std::to_string(row.recall.value()));
  ::testing::Test::RecordProperty("precision", std::to_string(row.precision.value()));
  return row;
}

// Circumference of 80 px in frontal views, seen without rotation: one fragment, whose first vertex
// is in the middle of an arc that crosses the horizontal epipolar lines.
testing::SceneCurve Ring() { return testing::Circle({0, 0, 0}, 40 / M_PI * testing::kFrontalPx); }

// Arrays of equal length, unit tangents along the curve, support sorted by view and with the
// anchor's own edgel.
void ExpectSound(const CurveSketch& sketch) {
  ASSERT_FALSE(sketch.curves.empty());
  for (const Curve3D& curve : sketch.curves) {
    ASSERT_GE(curve.size(), 2u);
    ASSERT_EQ(curve.tangents_in_world.size(), curve.size());
    ASSERT_EQ(curve.depth_sigma.size(), curve.size());
    ASSERT_EQ(curve.certain.size(), curve.size());
    ASSERT_EQ(curve.support.NumSamples(), curve.size());
    const auto& ids = Curves().at(curve.anchor.view).fragments.at(curve.anchor.fragment).edgel_ids;
    for (size_t s = 0; s < curve.size(); ++s) {
      EXPECT_NEAR(curve.tangents_in_world[s].norm(), 1, 1e-9);
      const EdgelRef own{curve.anchor.view, ids[(curve.anchor.begin + s) % ids.size()]};
      const auto support = curve.support.Of(s);
      EXPECT_TRUE(std::binary_search(support.begin(), support.end(), own));
      for (size_t k = 1; k < support.size(); ++k) EXPECT_LT(support[k - 1].view, support[k].view);
    }
  }
}

TEST(OriginalSketchTest, CurvesAreSound) { ExpectSound(Original().sketch); }

// A depth comes from edgels with a standard deviation of 0.2 px, divided by the sines of two
// angles: it is never better known than 0.2 footprints.
TEST(OriginalSketchTest, DepthsAreKnownNoBetterThanEdgels) {
  for (const Curve3D& curve : Original().sketch.curves) {
    const View& view = Views().at(curve.anchor.view);
    for (size_t s = 0; s < curve.size(); ++s) {
      const double depth = (view.cam_from_world * curve.points_in_world[s]).z();
      ASSERT_GE(curve.depth_sigma[s], 0.199 * depth / view.camera.MeanFocal());
    }
  }
}

TEST(OriginalSketchTest, FindsMostOfTheCube) {
  EXPECT_GE(Evaluate(Original().sketch, 2).recall.value(), 0.8);
}

// Two curves in line that the linker took for one in the first view, and for two in all others:
// every half is matched by itself.
TEST(OriginalSketchTest, StretchesOfAFragmentThatMatchDifferentCurvesDoNotCompete) {
  std::vector<ImageCurves> curves =
      testing::ProjectCurves(Views(), {testing::Segment({-0.8, -0.3, 0.1}, {-0.1, -0.05, 0.0}),
                                       testing::Segment({0.1, 0.02, -0.03}, {0.8, 0.27, -0.13})});
  std::vector<CurveFragment>& fragments = curves[0].fragments;
  const int half = static_cast<int>(fragments[0].edgel_ids.size());
  const std::vector<EdgelId> second_half = fragments[1].edgel_ids;
  fragments[0].edgel_ids.insert(fragments[0].edgel_ids.end(), second_half.begin(),
                                second_half.end());
  fragments.resize(1);
  const CurveSketch sketch =
      BuildOriginalSketch({Views(), curves, {}, std::nullopt}, SketchOptions(), {}).sketch;
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
        BuildOriginalSketch({Views(), Curves(), {}, std::nullopt}, options, {});
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
      const CurveSketch sketch =
          BuildOriginalSketch({views, curves, {}, std::nullopt}, options, {}).sketch;
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
  const CurveSketch sketch =
      BuildOriginalSketch({views, curves, {}, std::nullopt}, SketchOptions(), {}).sketch;
  EXPECT_GE(sketch.curves.size(), 9u);
}

// Each half of the ring is a curve, though one passes the first vertex of the fragment.
TEST(OriginalSketchTest, CurvesOfAClosedFragmentPassItsFirstVertex) {
  const auto views = testing::FrontalViews(9, 1, 0.4);
  const auto curves = testing::ProjectCurves(views, {Ring()});
  const CurveSketch sketch =
      BuildOriginalSketch({views, curves, {}, std::nullopt}, SketchOptions(), {}).sketch;
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

// The two sketches that judge sample by sample.
class LocalSketchTest : public ::testing::TestWithParam<SketchMode> {
 protected:
  static SketchResult Build(int num_threads = 2,
                            std::optional<Eigen::AlignedBox3d> box = std::nullopt) {
    return RunSketch(GetParam(), num_threads, box);
  }
};

INSTANTIATE_TEST_SUITE_P(Modes, LocalSketchTest,
                         ::testing::Values(SketchMode::kEnhanced, SketchMode::kSweep));

TEST_P(LocalSketchTest, FindsTheCubePreciselyInSoundCurves) {
  const SketchResult result = Build();
  ExpectSound(result.sketch);
  const TauResult row = Evaluate(result.sketch, 1);
  EXPECT_GE(row.recall.value(), 0.97);
  EXPECT_GE(row.precision.value(), 0.95);
}

TEST_P(LocalSketchTest, FatesTellWhichEdgelsAreInCurves) {
  const SketchResult result = Build();
  EdgelFates expected;
  for (size_t v = 0; v < Curves().size(); ++v) {
    ASSERT_EQ(result.fates.at(v).size(), Curves()[v].edge_map.edgels.size());
    expected.emplace_back(result.fates[v].size(), EdgelFate::kNotLinked);
  }
  for (const Curve3D& curve : result.sketch.curves) {
    const auto& ids = Curves().at(curve.anchor.view).fragments.at(curve.anchor.fragment).edgel_ids;
    for (size_t s = 0; s < curve.size(); ++s) {
      expected[curve.anchor.view][ids[(curve.anchor.begin + s) % ids.size()]] =
          EdgelFate::kSketched;
    }
  }
  for (size_t v = 0; v < expected.size(); ++v) {
    for (size_t id = 0; id < expected[v].size(); ++id) {
      EXPECT_EQ(result.fates[v][id] == EdgelFate::kSketched,
                expected[v][id] == EdgelFate::kSketched);
    }
  }
}

TEST_P(LocalSketchTest, ReconstructsOnlyInsideTheBox) {
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-2, -2, 0.1), Eigen::Vector3d(2, 2, 2));
  const CurveSketch sketch = Build(2, box).sketch;
  ASSERT_FALSE(sketch.curves.empty());
  // Samples between two inside are inside too; fitting may move them by a fraction of a pixel.
  for (const Curve3D& curve : sketch.curves) {
    for (const Eigen::Vector3d& point : curve.points_in_world) EXPECT_GT(point.z(), 0.1 - 0.01);
  }
}

// More views than whose support is held at once; the last ones by themselves are fewer.
TEST_P(LocalSketchTest, ViewsInSeveralBlocksMakeWhatTheyMakeInOne) {
  const auto views = testing::DomeViews(70, 5);
  const auto curves =
      testing::ProjectCurves(views, {testing::Segment({-0.8, -0.3, 0.1}, {0.7, 0.4, -0.2})});
  const SceneHints no_hints;
  SketchInput input{views, curves, no_hints, std::nullopt};
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

TEST_P(LocalSketchTest, SomeOfManyViewsOfOnePlaceAreSketched) {
  const auto views = testing::DomeViews(60, 5);
  const auto curves =
      testing::ProjectCurves(views, {testing::Segment({-0.8, -0.3, 0.1}, {0.7, 0.4, -0.2})});
  const SceneHints no_hints;
  SketchOptions options;
  options.view_selection.enough_primary_views = 10;
  const SketchResult result =
      BuildSketch(GetParam(), {views, curves, no_hints, std::nullopt}, options, {});
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
TEST_P(LocalSketchTest, TheUnitOfLengthDoesNotMatter) {
  const CurveSketch in_meters = Build().sketch;
  for (const double factor : {std::ldexp(1, -44), std::ldexp(1, 27), std::ldexp(1, 40)}) {
    const std::vector<View> views = testing::Scaled(Views(), factor);
    const CurveSketch sketch =
        BuildSketch(GetParam(), {views, Curves(), {}, std::nullopt}, SketchOptions(), {}).sketch;
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

TEST_P(LocalSketchTest, ThreadsDoNotMatter) {
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
