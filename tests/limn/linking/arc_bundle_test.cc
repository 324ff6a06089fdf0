// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/arc_bundle.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace limn {
namespace {

constexpr double kMaxCurvature = 0.2;

// On a circle through the origin, where it runs along x and has this curvature.
Edgel OnCircle(double curvature, double arc_px) {
  const double turn = curvature * arc_px;
  Edgel edgel;
  edgel.position_px = {std::sin(turn) / curvature, (1 - std::cos(turn)) / curvature};
  edgel.tangent_rad = turn;
  edgel.position_sigma_px = 0.05f;
  return edgel;
}

// Whether there are any arcs from the origin to the edgel.
bool ArcsFromOriginTo(const Edgel& edgel, const LinkingOptions& options, ArcBundle* bundle) {
  const ArcAnchor anchor(MakeArcSample(OnCircle(0.1, 0), options), kMaxCurvature);
  return anchor.ArcsTo(MakeArcSample(edgel, options), edgel.position_px.cast<float>(), bundle);
}

// The interval of the anchor as it is.
float CentralLow(const ArcBundle& bundle) { return bundle.low[4][3]; }
float CentralHigh(const ArcBundle& bundle) { return bundle.high[4][3]; }

TEST(ArcAnchor, ArcsThroughACircle) {
  for (const double curvature : {-0.15, -0.01, 0.02, 0.1}) {
    for (const double arc_px : {-3.0, -1.2, 0.9, 3.3}) {
      ArcBundle bundle;
      EXPECT_TRUE(ArcsFromOriginTo(OnCircle(curvature, arc_px), {}, &bundle));
      EXPECT_LT(CentralLow(bundle), curvature) << curvature << ", " << arc_px;
      EXPECT_GT(CentralHigh(bundle), curvature) << curvature << ", " << arc_px;
    }
  }
}

TEST(ArcAnchor, TheIntervalMissesByTheTolerance) {
  LinkingOptions options;
  options.position_tolerance_px = 0.2;
  const Edgel edgel = OnCircle(0.05, 3);
  ArcBundle bundle;
  EXPECT_TRUE(ArcsFromOriginTo(edgel, options, &bundle));
  // The flattest and the sharpest arc pass the edgel at the tolerance, unless its direction says
  // no: 15 degrees over 3 px are 0.087 / px, more than 0.2 px (0.044 / px).
  for (const float curvature : {CentralLow(bundle), CentralHigh(bundle)}) {
    const Eigen::Vector2d to_center = edgel.position_px - Eigen::Vector2d(0, 1 / curvature);
    EXPECT_NEAR(std::abs(to_center.norm() - std::abs(1 / curvature)), 0.2, 1e-3);
  }
}

TEST(Intersect, OnlyWhatFitsBoth) {
  LinkingOptions options;
  options.position_tolerance_px = 0.05;
  options.max_position_tolerance_px = 0.05;
  options.angle_tolerance_deg = 2;
  ArcBundle left, farther_left, right, too_sharp, both;
  EXPECT_TRUE(ArcsFromOriginTo(OnCircle(0.15, 3), options, &left));
  EXPECT_TRUE(ArcsFromOriginTo(OnCircle(0.15, -2), options, &farther_left));
  EXPECT_TRUE(ArcsFromOriginTo(OnCircle(-0.15, 3), options, &right));
  EXPECT_TRUE(Intersect(left, farther_left, &both));
  EXPECT_FALSE(Intersect(left, right, &both));
  EXPECT_FALSE(ArcsFromOriginTo(OnCircle(0.4, 3), options, &too_sharp));
}

}  // namespace
}  // namespace limn
