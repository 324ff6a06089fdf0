// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/saw_teeth.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

constexpr double kToothFootprint = 0.01;  // depth 10, focal length 1000

std::vector<View> OneView() {
  View view = testing::ForwardView(1001, 1001, 1000);
  view.cam_from_world.translation = {0, 0, 10};
  return {view};
}

// Teeth of +-height at every `step`, both in footprints.
Polyline3d Teeth(double length, double step, double height) {
  Polyline3d curve;
  const int count = static_cast<int>(std::lround(length / step));
  for (int i = 0; i <= count; ++i) {
    curve.push_back({i * step * kToothFootprint, (i % 2 ? height : -height) * kToothFootprint, 0});
  }
  return curve;
}

TEST(SawTeeth, StraightLineHasNone) {
  const Polyline3d line = {{-1, 0, 0}, {0.3, 0, 0}, {1, 0, 0}};
  EXPECT_NEAR(*LengthOverSmoothed(line, OneView()), 1, 1e-9);
}

TEST(SawTeeth, TeethMakeACurveLonger) {
  // Slope 1 everywhere: sqrt(2) times as long. The smoothed curve keeps its ends, which lie a tooth
  // apart, and what is left of the teeth there.
  EXPECT_NEAR(*LengthOverSmoothed(Teeth(200, 2, 1), OneView()), std::sqrt(2), 0.03);
  EXPECT_NEAR(*LengthOverSmoothed(Teeth(200, 2, 0.1), OneView()), std::hypot(1, 0.1), 0.003);
}

TEST(SawTeeth, CircleShrinksByTheWindow) {
  constexpr double kRadiusPx = 20;
  Polyline3d circle;
  for (int i = 0; i <= 3600; ++i) {
    const double angle = 2 * M_PI * i / 3600;
    circle.push_back(kRadiusPx * kToothFootprint *
                     Eigen::Vector3d(std::cos(angle), std::sin(angle), 0));
  }
  const double half_angle = 7.5 / kRadiusPx;
  // A closed curve is cut: the window at the cut is smaller.
  EXPECT_NEAR(*LengthOverSmoothed(circle, OneView()), half_angle / std::sin(half_angle), 0.006);
}

TEST(SawTeeth, ShortCurvesAreLeftOut) {
  const std::vector<View> views = OneView();
  EXPECT_FALSE(LengthOverSmoothed(Teeth(10, 2, 0), views));
  EXPECT_FALSE(LengthOverSmoothed({}, views));
  const SawTeeth teeth = MeasureSawTeeth({Teeth(10, 2, 0), {}, {{0, 0, 0}, {0, 0, 0}}}, views);
  EXPECT_EQ(teeth.num_curves, 0);
  EXPECT_FALSE(teeth.median);
}

TEST(SawTeeth, CountsCurvesAndLengths) {
  // Nine short smooth curves and one long rough one.
  std::vector<Polyline3d> curves(9, Teeth(20, 2, 0));
  curves.push_back(Teeth(400, 2, 1));
  const SawTeeth teeth = MeasureSawTeeth(curves, OneView());
  EXPECT_EQ(teeth.num_curves, 10);
  EXPECT_NEAR(*teeth.median, 1, 1e-9);
  EXPECT_NEAR(*teeth.p90, 1, 1e-9);
  EXPECT_NEAR(*teeth.median_by_length, std::sqrt(2), 0.03);
}

TEST(SawTeeth, RefusesBadInput) {
  EXPECT_THROW(MeasureSawTeeth({}, {}), InputError);
  EXPECT_THROW(MeasureSawTeeth({}, OneView(), {.window_px = 0}), OptionError);
}

}  // namespace
}  // namespace limn
