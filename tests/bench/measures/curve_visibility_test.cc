// SPDX-License-Identifier: BSD-3-Clause
#include "bench/measures/curve_visibility.h"

#include <cmath>

#include <gtest/gtest.h>

#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::Polylines;
using testing::ProjectCurves;
using testing::SceneCurve;
using testing::Segment;

constexpr double kCameraDistance = 4;

View ViewAtAzimuth(double degrees) { return testing::RingView(degrees, kCameraDistance, 1); }

// One upright segment, asked for in a view at azimuth 0.
class CurveVisibilityTest : public ::testing::Test {
 protected:
  CurveVisibilityTest() : scene_{Segment({0, 0, -0.5}, {0, 0, 0.5})} {}

  // Known views at these azimuths, which show the segment or nothing.
  ForetoldView Foretell(const std::vector<double>& azimuths, const std::vector<bool>& shows,
                        const VisibilityOptions& options = {}) const {
    std::vector<View> views;
    std::vector<ImageCurves> curves;
    SupportedCurve supported{Polylines(scene_).front(), {}};
    for (size_t v = 0; v < azimuths.size(); ++v) {
      views.push_back(ViewAtAzimuth(azimuths[v]));
      curves.push_back(shows[v] ? ProjectCurves(views.back(), scene_) : ImageCurves());
      supported.supporting_views.push_back(static_cast<ViewId>(v));
    }
    const std::vector<SupportedCurve> supported_curves = {supported};
    const CurveVisibility visibility(supported_curves, views, curves, options, {});
    return visibility.Foretell(ViewAtAzimuth(0), {});
  }

  std::vector<SceneCurve> scene_;
};

TEST_F(CurveVisibilityTest, IsSureWhereTheTwoNearestViewsShowTheCurve) {
  const ForetoldView foretold = Foretell({-10, 10, 20}, {true, true, false});
  // A meter at four meters and 600 px, seen from a little above.
  EXPECT_NEAR(static_cast<double>(foretold.sure.size()), 150, 10);
  EXPECT_EQ(foretold.sure.size(), foretold.possible.edgels.size());
  EXPECT_NEAR(std::abs(std::sin(foretold.sure.front().tangent_rad)), 1, 1e-6);
}

TEST_F(CurveVisibilityTest, IsPossibleWhereOneOfThemDoesNot) {
  for (const std::vector<bool>& shows :
       {std::vector<bool>{false, true, true}, {true, false, true}, {false, false, true}}) {
    const ForetoldView foretold = Foretell({-10, 12, 20}, shows);
    EXPECT_TRUE(foretold.sure.empty());
    EXPECT_FALSE(foretold.possible.edgels.empty());
  }
}

TEST_F(CurveVisibilityTest, IsNotToldByViewsFarAside) {
  EXPECT_TRUE(Foretell({-40, 40}, {true, true}).possible.edgels.empty());
  EXPECT_FALSE(Foretell({-40, 40}, {true, true}, {.max_viewing_angle_deg = 50}).sure.empty());
  EXPECT_TRUE(Foretell({-10, 10}, {false, false}).possible.edgels.empty());
}

TEST_F(CurveVisibilityTest, OneViewIsNotSure) {
  const ForetoldView foretold = Foretell({10}, {true});
  EXPECT_TRUE(foretold.sure.empty());
  EXPECT_FALSE(foretold.possible.edgels.empty());
}

TEST(VisibilityOptions, AreChecked) {
  EXPECT_THROW(VisibilityOptions{.max_viewing_angle_deg = 0}.Check(), OptionError);
  EXPECT_THROW(VisibilityOptions{.shown_distance_px = -1}.Check(), OptionError);
}

}  // namespace
}  // namespace limn
