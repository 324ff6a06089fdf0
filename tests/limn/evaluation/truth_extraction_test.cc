// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/truth_extraction.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "limn/evaluation/sharp_edges.h"
#include "limn/util/errors.h"
#include "support/meshes.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::CubeEdges;
using testing::CubeMesh;
using testing::LookAt;
using testing::ProjectCurves;
using testing::SceneCurve;
using testing::Segment;

constexpr double kHalf = 0.5;

// Three views of the same side of a cube, which see its faces +x, +y and +z: nine edges.
class CubeTruth : public ::testing::Test {
 protected:
  CubeTruth()
      : mesh_(CubeMesh({0, 0, 0}, kHalf)),
        edges_(FindSharpEdges(mesh_, {})),
        views_{LookAt({3, 2.5, 2}, {0, 0, 0}), LookAt({2.5, 3, 2.2}, {0, 0, 0}),
               LookAt({2.6, 2.7, 3}, {0, 0, 0})} {}

  ExtractedTruth Extract(const std::vector<SceneCurve>& in_images,
                         TruthOptions options = {}) const {
    return ExtractTruthCurves(edges_, mesh_, views_, ProjectCurves(views_, in_images), options,
                              RunContext());
  }

  TriangleMesh mesh_;
  std::vector<Polyline3d> edges_;
  std::vector<View> views_;
};

TEST_F(CubeTruth, HiddenEdgesAreNotKeptThoughImagesShowSomethingThere) {
  // The images show all twelve, as if the cube were of glass.
  const ExtractedTruth truth = Extract(CubeEdges(kHalf));
  ASSERT_EQ(truth.set.polylines.size(), 9u);
  for (const Polyline3d& curve : truth.set.polylines) {
    // Whole edges, to the last bit, none at the hidden corner.
    EXPECT_DOUBLE_EQ(Length(curve), 2 * kHalf);
    for (const Eigen::Vector3d& end : curve) EXPECT_NE(end, Eigen::Vector3d::Constant(-kHalf));
  }
  EXPECT_NEAR(truth.account.found, 12, 1e-9);
  EXPECT_NEAR(truth.account.visible, 9, 0.1);
  EXPECT_NEAR(truth.account.shown, 9, 0.1);
  EXPECT_NEAR(truth.account.kept, 9, 1e-9);
}

TEST_F(CubeTruth, EdgesThatNoImageShowsAreNotKept) {
  const std::vector<SceneCurve> all = CubeEdges(kHalf);
  std::vector<SceneCurve> shown;
  for (const SceneCurve& edge : all) {
    const bool is_upper = edge.points[0].z() > 0 && edge.points[1].z() > 0;
    if (is_upper) shown.push_back(edge);
  }
  ASSERT_EQ(shown.size(), 4u);
  const ExtractedTruth truth = Extract(shown);
  ASSERT_EQ(truth.set.polylines.size(), 4u);
  for (const Polyline3d& curve : truth.set.polylines) {
    for (const Eigen::Vector3d& point : curve) EXPECT_EQ(point.z(), kHalf);
  }
  EXPECT_NEAR(truth.account.visible, 9, 0.1);
}

TEST_F(CubeTruth, WithoutEdgesWhatIsVisibleIsKept) {
  TruthOptions options;
  options.require_edges = false;
  const ExtractedTruth truth = ExtractTruthCurves(edges_, mesh_, views_, {}, options, RunContext());
  EXPECT_EQ(truth.set.polylines.size(), 9u);
  // A fourth view from the other side sees the hidden three and more; each is seen by one view.
  std::vector<View> views = views_;
  views.push_back(LookAt({-3, -2.5, -2}, {0, 0, 0}));
  EXPECT_EQ(ExtractTruthCurves(edges_, mesh_, views, {}, options, {}).set.polylines.size(), 9u);
  options.min_views = 1;
  EXPECT_EQ(ExtractTruthCurves(edges_, mesh_, views, {}, options, {}).set.polylines.size(), 12u);
}

TEST_F(CubeTruth, TooFewViewsKeepNothing) {
  TruthOptions options;
  options.min_views = 4;
  EXPECT_THROW(Extract(CubeEdges(kHalf), options), OptionError);
  std::vector<ImageCurves> curves = ProjectCurves(views_, CubeEdges(kHalf));
  curves[1] = ImageCurves();
  options.min_views = 3;
  const ExtractedTruth truth =
      ExtractTruthCurves(edges_, mesh_, views_, curves, options, RunContext());
  EXPECT_TRUE(truth.set.polylines.empty());
  EXPECT_EQ(truth.account.kept, 0);
}

TEST_F(CubeTruth, EdgelsTooFarAwayDoNotCount) {
  // Images of a cube 4 % larger: its edges are about 3 px outside.
  TruthOptions options;
  options.max_distance_px = 0.5;
  EXPECT_LT(Extract(CubeEdges(1.04 * kHalf), options).account.shown, 2);
  options.max_distance_px = 6;
  EXPECT_NEAR(Extract(CubeEdges(1.04 * kHalf), options).account.kept, 9, 0.5);
}

TEST_F(CubeTruth, ShortRunsAreDroppedAndShortGapsClosed) {
  // Of one edge 0.55 is shown, with a gap, and 0.02 more at the other end.
  const Eigen::Vector3d from(kHalf, -kHalf, kHalf);
  const auto at = [&](double t) -> Eigen::Vector3d { return from + t * Eigen::Vector3d::UnitY(); };
  const double footprint = 4.2 / 600;
  const std::vector<SceneCurve> shown = {Segment(at(0), at(0.3)),
                                         Segment(at(0.3 + 12 * footprint), at(0.55)),
                                         Segment(at(0.98), at(1))};
  const ExtractedTruth truth = Extract(shown, {.max_gap_px = 16});
  ASSERT_EQ(truth.set.polylines.size(), 1u);
  const Polyline3d& curve = truth.set.polylines[0];
  EXPECT_TRUE(curve.front() == from || curve.back() == from);
  EXPECT_NEAR(truth.account.kept, 0.55, 4 * footprint);
  EXPECT_EQ(Extract(shown, {.max_gap_px = 0}).set.polylines.size(), 2u);
  EXPECT_TRUE(Extract(shown, {.max_gap_px = 16, .min_length_px = 90}).set.polylines.empty());
}

TEST_F(CubeTruth, UnitOfLengthDoesNotMatter) {
  for (const double factor : {1e-4, 1e5}) {
    const TriangleMesh mesh = CubeMesh({0, 0, 0}, factor * kHalf);
    const ExtractedTruth truth =
        ExtractTruthCurves(FindSharpEdges(mesh, {}), mesh, testing::Scaled(views_, factor),
                           ProjectCurves(views_, CubeEdges(kHalf)), {}, RunContext());
    EXPECT_EQ(truth.set.polylines.size(), 9u);
    EXPECT_NEAR(truth.account.kept, 9 * factor, 1e-9 * factor);
  }
}

TEST_F(CubeTruth, SameResultWithAnyNumberOfThreads) {
  const std::vector<ImageCurves> curves = ProjectCurves(views_, CubeEdges(kHalf), 0.3);
  RunContext one, three;
  one.num_threads = 1;
  three.num_threads = 3;
  EXPECT_EQ(ExtractTruthCurves(edges_, mesh_, views_, curves, {}, one).set.polylines,
            ExtractTruthCurves(edges_, mesh_, views_, curves, {}, three).set.polylines);
}

TEST(ExtractTruthCurves, ClosedCurveIsKeptAcrossItsSeam) {
  // The rim of a disc; the images show all of it but an arc away from its first vertex.
  SceneCurve arc;
  std::vector<Eigen::Vector3d> vertices;
  std::vector<int> polygon;
  constexpr int kCount = 180;
  for (int i = 0; i < kCount; ++i) {
    vertices.emplace_back(std::cos(2 * M_PI * i / kCount), std::sin(2 * M_PI * i / kCount), 0);
    polygon.push_back(i);
  }
  for (int i = -60; i <= 60; ++i) arc.points.push_back(vertices[(i + kCount) % kCount]);
  const TriangleMesh disc = MakeTriangleMesh(vertices, {polygon});
  const std::vector<View> views = testing::DomeViews(4, 5);
  const ExtractedTruth truth = ExtractTruthCurves(FindSharpEdges(disc, {}), disc, views,
                                                  ProjectCurves(views, {arc}), {}, RunContext());
  ASSERT_EQ(truth.set.polylines.size(), 1u);
  EXPECT_NEAR(Length(truth.set.polylines[0]), 2 * M_PI * 120 / kCount, 0.1);
}

// A cloud of two walls, one behind the other; the images show a line on each.
TEST(ExtractTruthPoints, KeepsVisiblePointsNearEdges) {
  std::vector<Eigen::Vector3d> cloud;
  for (const double y : {0.0, 1.0}) {
    for (int i = -80; i <= 80; ++i) {
      for (int k = -80; k <= 80; ++k) cloud.emplace_back(0.01 * i, y, 0.01 * k);
    }
  }
  const std::vector<View> views = {LookAt({0, -6, 0}, {0, 0, 0}), LookAt({0.6, -6, 0.3}, {0, 0, 0}),
                                   LookAt({-0.5, -6, 0.6}, {0, 0, 0})};
  const std::vector<ImageCurves> curves = ProjectCurves(
      views, {Segment({-0.5, 0, 0}, {0.5, 0, 0}), Segment({0, 1, -0.4}, {0, 1, 0.4})});
  const ExtractedTruth truth = ExtractTruthPoints(cloud, views, curves, {}, RunContext());
  EXPECT_EQ(truth.account.found, static_cast<double>(cloud.size()));
  EXPECT_LT(truth.account.visible, 0.75 * static_cast<double>(cloud.size()));
  EXPECT_EQ(truth.account.kept, static_cast<double>(truth.set.points.size()));
  ASSERT_GT(truth.set.points.size(), 100u);
  int on_the_line = 0;
  for (const Eigen::Vector3d& point : truth.set.points) {
    EXPECT_EQ(point.y(), 0);
    EXPECT_LT(std::abs(point.z()), 0.5);
    on_the_line += std::abs(point.z()) < 0.0101;
  }
  // The line of the hidden wall crosses the front one at other places in each view.
  EXPECT_GT(on_the_line, 0.9 * static_cast<double>(truth.set.points.size()));
  EXPECT_EQ(ExtractTruthPoints(cloud, views, {}, {.require_edges = false}, {}).account.shown,
            truth.account.visible);
}

// Edgels everywhere say nothing of a point.
TEST(ExtractTruthPoints, LeavesOutWhatChanceExplains) {
  const std::vector<View> views = testing::DomeViews(12, 5);
  std::vector<ImageCurves> full;
  for (const View& view : views) {
    ImageCurves curves;
    for (double y = 10; y < 470; y += 2.5) {
      CurveFragment row;
      for (double x = 10; x < 630; x += 2.5) {
        row.edgel_ids.push_back(static_cast<EdgelId>(curves.edge_map.edgels.size()));
        curves.edge_map.edgels.push_back(testing::MakeEdgel({x, y}, 0));
      }
      curves.fragments.push_back(row);
    }
    full.push_back(std::move(curves));
    full.back().edge_map.width = view.camera.width;
    full.back().edge_map.height = view.camera.height;
  }
  const std::vector<Eigen::Vector3d> cloud = {{0, 0, 0}, {0.4, 0.1, 0.2}};
  const ExtractedTruth truth = ExtractTruthPoints(cloud, views, full, {}, RunContext());
  EXPECT_EQ(truth.account.shown, 2);
  EXPECT_EQ(truth.account.kept, 0);
  EXPECT_EQ(ExtractTruthPoints(cloud, views, full, {.max_chance = 1}, {}).account.kept, 2);
}

TEST(TruthOptions, AreChecked) {
  EXPECT_THROW(TruthOptions{.min_views = 0}.Check(), OptionError);
  EXPECT_THROW(TruthOptions{.max_distance_px = 0}.Check(), OptionError);
  EXPECT_THROW(TruthOptions{.occlusion_px = -1}.Check(), OptionError);
  EXPECT_THROW(TruthOptions{.min_length_px = -1}.Check(), OptionError);
  EXPECT_THROW(TruthOptions{.splat_px = 0}.Check(), OptionError);
  EXPECT_THROW(TruthOptions{.max_chance = 0}.Check(), OptionError);
}

}  // namespace
}  // namespace limn
