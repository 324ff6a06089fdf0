// SPDX-License-Identifier: BSD-3-Clause
#include "bench/measures/held_out_reprojection.h"

#include <numeric>

#include <gtest/gtest.h>

#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::CubeEdges;
using testing::DomeViews;
using testing::Polylines;
using testing::ProjectCurves;
using testing::SceneCurve;

constexpr double kDistance = 4;
constexpr double kFootprint = kDistance / 600;

// A cube of wires seen by views around it, every fifth of which is kept out.
class HeldOut : public ::testing::Test {
 protected:
  HeldOut() : scene_(CubeEdges(0.5)) {
    const std::vector<View> views = DomeViews(30, kDistance);
    for (size_t v = 0; v < views.size(); ++v) {
      (v % 5 == 2 ? held_out_views_ : training_views_).push_back(views[v]);
    }
    training_curves_ = ProjectCurves(training_views_, scene_);
    held_out_curves_ = ProjectCurves(held_out_views_, scene_);
  }

  // Curves that say all training views have seen them.
  std::vector<SupportedCurve> Supported(const std::vector<Polyline3d>& polylines) const {
    std::vector<ViewId> all(training_views_.size());
    std::iota(all.begin(), all.end(), 0);
    std::vector<SupportedCurve> curves;
    for (const Polyline3d& polyline : polylines) curves.push_back({polyline, all});
    return curves;
  }

  HeldOutReport Measure(const std::vector<SupportedCurve>& curves,
                        const HeldOutOptions& options = {}) const {
    return MeasureHeldOut(curves,
                          {training_views_, training_curves_, held_out_views_, held_out_curves_},
                          options, {});
  }

  std::vector<SceneCurve> scene_;
  std::vector<View> training_views_, held_out_views_;
  std::vector<ImageCurves> training_curves_, held_out_curves_;
};

TEST_F(HeldOut, TrueCurvesFallOnTheEdgelsAndBack) {
  const HeldOutReport report = Measure(Supported(Polylines(scene_)));
  EXPECT_GT(report.to_edgels.count, 1000);
  EXPECT_GT(report.from_edgels.count, 1000);
  EXPECT_LT(*report.to_edgels.median_px, 0.05);
  EXPECT_LT(*report.to_edgels.p90_px, 0.3);
  EXPECT_LT(*report.from_edgels.median_px, 0.05);
  EXPECT_LT(*report.from_edgels.p90_px, 0.3);
  EXPECT_LT(*report.from_edgels.lonely, 0.02);
}

TEST_F(HeldOut, ShiftedCurvesAreOffByTheirShift) {
  std::vector<Polyline3d> shifted = Polylines(scene_);
  for (Polyline3d& polyline : shifted) {
    for (Eigen::Vector3d& point : polyline) point.z() += 1.5 * kFootprint;
  }
  const HeldOutReport report = Measure(Supported(shifted));
  // Edges that look upright in the image move along themselves; the others by up to the shift.
  EXPECT_GT(*report.to_edgels.p90_px, 0.9);
  EXPECT_LT(*report.to_edgels.p90_px, 1.7);
  EXPECT_GT(*report.from_edgels.p90_px, 0.9);
}

TEST_F(HeldOut, MissingCurvesLeaveEdgelsLonely) {
  std::vector<Polyline3d> half = Polylines(scene_);
  half.resize(half.size() / 2);
  const HeldOutReport report = Measure(Supported(half));
  EXPECT_LT(*report.to_edgels.p90_px, 0.3);
  EXPECT_NEAR(*report.from_edgels.lonely, 0.5, 0.15);
  EXPECT_DOUBLE_EQ(*report.from_edgels.p90_px, HeldOutOptions().cap_px);
}

TEST_F(HeldOut, CurvesThatNoNeighborShowsAreNotAsked) {
  // In the air, where no image has an edge; and true curves that only a view far aside supports.
  EXPECT_EQ(Measure(Supported({{{0, 0, 0.7}, {0.3, 0.1, 0.7}}})).to_edgels.count, 0);
  std::vector<SupportedCurve> curves = Supported(Polylines(scene_));
  for (SupportedCurve& curve : curves) curve.supporting_views.clear();
  const HeldOutReport report = Measure(curves);
  EXPECT_EQ(report.to_edgels.count, 0);
  EXPECT_FALSE(report.to_edgels.median_px);
  EXPECT_DOUBLE_EQ(*report.from_edgels.lonely, 1);
}

TEST_F(HeldOut, ShortFragmentsAreNotAsked) {
  HeldOutOptions options;
  options.min_fragment_length_px = 1e4;
  EXPECT_EQ(Measure(Supported(Polylines(scene_)), options).from_edgels.count, 0);
  options.cap_px = 0;
  EXPECT_THROW(Measure({}, options), OptionError);
}

}  // namespace
}  // namespace limn
