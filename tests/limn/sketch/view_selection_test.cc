// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/view_selection.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/geometry/angle_between.h"
#include "limn/model/curves_scene.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::LookAt;

// Angle at the origin between two cameras.
double AngleDeg(const View& a, const View& b) {
  const Vector3d u = a.CenterInWorld().normalized(), v = b.CenterInWorld().normalized();
  return Degrees(AngleBetween(u, v));
}

// Cameras at equal steps once around the origin.
std::vector<View> Turntable(int count) {
  std::vector<View> views;
  for (int i = 0; i < count; ++i) {
    views.push_back(testing::RingView(360.0 * i / count, 5, 2));
  }
  return views;
}

void ExpectSoundSelection(const std::vector<ViewPlan>& plans, const ViewSelectionOptions& options) {
  for (size_t v = 0; v < plans.size(); ++v) {
    for (const auto* chosen : {&plans[v].second_views, &plans[v].confirmation_views}) {
      const std::set<ViewId> unique(chosen->begin(), chosen->end());
      EXPECT_EQ(unique.size(), chosen->size()) << "view " << v;
      EXPECT_EQ(unique.count(static_cast<ViewId>(v)), 0u) << "view " << v;
      for (const ViewId other : unique) {
        EXPECT_GE(other, 0);
        EXPECT_LT(other, static_cast<ViewId>(plans.size()));
      }
    }
    EXPECT_LE(plans[v].second_views.size(), static_cast<size_t>(options.max_second_views));
    EXPECT_LE(plans[v].confirmation_views.size(),
              static_cast<size_t>(options.max_confirmation_views));
  }
}

// The fields of view have only depths from 59 to 61 in common.
TEST(ViewSelectionTest, LongLensesAreMatchedWhereTheirAxesMeet) {
  std::vector<View> views;
  for (int i = 0; i < 12; ++i) views.push_back(testing::RingView(6.0 * i, 60, 10));
  for (View& view : views) {
    view.camera.fx *= 20;
    view.camera.fy *= 20;
  }
  for (const ViewPlan& plan : SelectViews(views, kNoHints, {}, {})) {
    EXPECT_LT(plan.min_depth, 60.5);
    EXPECT_GT(plan.max_depth, 61.5);
    EXPECT_GE(plan.second_views.size(), 3u);
  }
}

TEST(ViewSelectionTest, TurntableMatchesNeighborsAndCoversTheScene) {
  const std::vector<View> views = Turntable(36);
  const ViewSelectionOptions options;
  const std::vector<ViewPlan> plans = SelectViews(views, kNoHints, options, {});
  ASSERT_EQ(plans.size(), views.size());
  ExpectSoundSelection(plans, options);
  const double distance = views[0].CenterInWorld().norm();
  for (size_t v = 0; v < views.size(); ++v) {
    EXPECT_LT(plans[v].min_depth, distance - 1) << "view " << v;
    EXPECT_GT(plans[v].max_depth, distance + 1) << "view " << v;
    EXPECT_GE(plans[v].second_views.size(), 4u) << "view " << v;
    EXPECT_GE(plans[v].confirmation_views.size(), 6u) << "view " << v;
    // The best second view is a usable neighbor on the arc.
    const double best = AngleDeg(views[v], views[plans[v].second_views.at(0)]);
    EXPECT_GE(best, options.min_pair_angle_deg);
    EXPECT_LE(best, options.max_pair_angle_deg);
  }
}

TEST(ViewSelectionTest, TurntablePicksBothSides) {
  const std::vector<View> views = Turntable(36);
  const std::vector<ViewPlan> plans = SelectViews(views, kNoHints, ViewSelectionOptions(), {});
  for (int v = 0; v < 36; ++v) {
    int left = 0, right = 0;
    for (const ViewId other : plans[v].second_views) {
      const int steps = (other - v + 36) % 36;
      (steps < 18 ? left : right) += 1;
    }
    EXPECT_GE(left, 1) << "view " << v;
    EXPECT_GE(right, 1) << "view " << v;
  }
}

TEST(ViewSelectionTest, TwoViewsAreTooFew) {
  std::vector<View> views = testing::DomeViews(16, 5);
  views.resize(2);
  EXPECT_THROW(SelectViews(views, kNoHints, ViewSelectionOptions(), {}), InputError);
  EXPECT_THROW(SelectViews({}, kNoHints, ViewSelectionOptions(), {}), InputError);
}

TEST(ViewSelectionTest, ThreeViewsAreEnough) {
  const std::vector<View> views = {LookAt({5, 0, 1}, {0, 0, 0}), LookAt({4.8, 1, 1}, {0, 0, 0}),
                                   LookAt({4.8, 0, 2}, {0, 0, 0})};
  const std::vector<ViewPlan> plans = SelectViews(views, kNoHints, ViewSelectionOptions(), {});
  ASSERT_EQ(plans.size(), 3u);
  for (const ViewPlan& plan : plans) EXPECT_EQ(plan.second_views.size(), 2u);
}

TEST(ViewSelectionTest, CamerasAtOneCenterAreAnInputError) {
  std::vector<View> views;
  for (int i = 0; i < 5; ++i) {
    views.push_back(LookAt({0, 0, 0}, {5 * std::cos(0.3 * i), 5 * std::sin(0.3 * i), 1}));
  }
  EXPECT_THROW(SelectViews(views, kNoHints, ViewSelectionOptions(), {}), InputError);
}

// The same away from the world's origin, where the centers agree only up to rounding.
TEST(ViewSelectionTest, CamerasAtOneCenterElsewhereAreAnInputError) {
  std::vector<View> views;
  for (int i = 0; i < 5; ++i) {
    const Vector3d center(3.1, -2.7, 1.3);
    views.push_back(
        LookAt(center, center + Vector3d(5 * std::cos(0.3 * i), 5 * std::sin(0.3 * i), 1)));
  }
  EXPECT_THROW(SelectViews(views, kNoHints, ViewSelectionOptions(), {}), InputError);
}

// Views to all sides, which do not overlap, as those of the parts of panoramas, at each of these
// centers.
constexpr int kNumSides = 6;
std::vector<View> AllAround(const std::vector<Vector3d>& centers) {
  std::vector<View> views;
  for (const Vector3d& center : centers) {
    for (int i = 0; i < kNumSides; ++i) {
      const double azimuth = 2 * M_PI * i / kNumSides;
      const Vector3d ahead(std::cos(azimuth), std::sin(azimuth), 0.1 * (i % 3 - 1));
      views.push_back(LookAt(center, center + ahead));
    }
  }
  return views;
}

// However many views there are.
TEST(ViewSelectionTest, TwoCentersAreTooFew) {
  const std::vector<View> views = AllAround({{3.1, -2.7, 1.3}, {4.2, -2.5, 1.4}});
  EXPECT_THAT([&] { SelectViews(views, kNoHints, {}, {}); },
              ::testing::ThrowsMessage<InputError>(
                  ::testing::HasSubstr("at 3 places at least, but all are at 2")));
}

TEST(ViewSelectionTest, ThreeCentersAreEnoughForEveryView) {
  const std::vector<View> views =
      AllAround({{3.1, -2.7, 1.3}, {4.1, -2.7, 1.4}, {3.6, -1.9, 1.35}});
  const ViewSelectionOptions options;
  const auto plans = SelectViews(views, kNoHints, options, {});
  ExpectSoundSelection(plans, options);
  for (size_t v = 0; v < plans.size(); ++v) {
    std::set<size_t> centers;
    for (const ViewId other : plans[v].second_views) centers.insert(other / kNumSides);
    EXPECT_EQ(centers.size(), 2u) << "view " << v;
    EXPECT_EQ(centers.count(v / kNumSides), 0u) << "view " << v;
  }
}

TEST(ViewSelectionTest, OptionsBoundTheSelections) {
  ViewSelectionOptions options;
  options.max_second_views = 3;
  options.max_confirmation_views = 5;
  const std::vector<ViewPlan> plans = SelectViews(testing::DomeViews(30, 5), kNoHints, options, {});
  ExpectSoundSelection(plans, options);
  for (const ViewPlan& plan : plans) {
    EXPECT_EQ(plan.second_views.size(), 3u);
    EXPECT_EQ(plan.confirmation_views.size(), 5u);
  }
}

TEST(ViewSelectionTest, VideoPicksSpreadViews) {
  // 240 frames at steps of half a degree: the neighbors are useless as partners.
  std::vector<View> views;
  for (int i = 0; i < 240; ++i) {
    views.push_back(testing::RingView(0.5 * i, 5, 2));
  }
  const ViewSelectionOptions options;
  const std::vector<ViewPlan> plans = SelectViews(views, kNoHints, options, {});
  ExpectSoundSelection(plans, options);
  for (const size_t v : {size_t{0}, size_t{60}, size_t{120}, size_t{239}}) {
    ASSERT_GE(plans[v].second_views.size(), 3u) << "view " << v;
    double smallest = 180, low = 360, high = -360;
    for (const ViewId other : plans[v].second_views) {
      smallest = std::min(smallest, AngleDeg(views[v], views[other]));
      low = std::min(low, 0.5 * other);
      high = std::max(high, 0.5 * other);
    }
    EXPECT_GE(smallest, options.min_pair_angle_deg - 0.5) << "view " << v;
    EXPECT_GE(high - low, 15) << "view " << v;
  }
}

TEST(ViewSelectionTest, ThreadsDoNotMatter) {
  const std::vector<View> views = testing::DomeViews(20, 5);
  RunContext one, two;
  one.num_threads = 1;
  two.num_threads = 2;
  const auto a = SelectViews(views, kNoHints, ViewSelectionOptions(), one);
  const auto b = SelectViews(views, kNoHints, ViewSelectionOptions(), two);
  for (size_t v = 0; v < views.size(); ++v) {
    EXPECT_EQ(a[v].second_views, b[v].second_views);
    EXPECT_EQ(a[v].confirmation_views, b[v].confirmation_views);
    EXPECT_EQ(a[v].min_depth, b[v].min_depth);
    EXPECT_EQ(a[v].max_depth, b[v].max_depth);
  }
}

TEST(ViewSelectionTest, PointsWidenTheDepthRange) {
  const std::vector<View> views = Turntable(12);
  SceneHints hints;
  for (int i = 0; i < 200; ++i) {
    hints.points.push_back({Vector3d(-200.0 - i, 0, 0), {0, 1}});  // far behind the scene
  }
  const auto without = SelectViews(views, kNoHints, ViewSelectionOptions(), {});
  const auto with = SelectViews(views, hints, ViewSelectionOptions(), {});
  EXPECT_GT(with[0].max_depth, 350);
  EXPECT_GT(with[0].max_depth, without[0].max_depth);
  EXPECT_LE(with[0].min_depth, without[0].min_depth);
  EXPECT_EQ(with[5].max_depth, without[5].max_depth);
}

// Cameras along x, `step` apart, that look at a facade `distance` away, by turns a little to the
// left and to the right.
std::vector<View> Street(int count, double step, double distance) {
  std::vector<View> views;
  for (int i = 0; i < count; ++i) {
    const double x = step * i;
    const double turn = 0.2 * distance * (i % 3 - 1);
    views.push_back(LookAt({x, 0, 1.5 + 0.1 * (i % 4)}, {x + turn, distance, 3}));
  }
  return views;
}

// Every fifth meter of the facade, seen by the cameras in front of it.
SceneHints FacadePoints(const std::vector<View>& views, double step, double distance) {
  SceneHints hints;
  for (int i = 0; i < 4 * static_cast<int>(views.size()); ++i) {
    ScenePoint point{Vector3d(0.25 * step * i, distance + 0.3 * (i % 5), i % 7), {}};
    for (int v = std::max(0, i / 4 - 12); v < std::min<int>(views.size(), i / 4 + 13); ++v) {
      if (views[v].Project(point.position_in_world)) point.views.push_back(v);
    }
    hints.points.push_back(std::move(point));
  }
  return hints;
}

// Every plan reaches the facade and consists of views around its own, nearly as many as asked for.
void ExpectFacadePlans(const std::vector<View>& views, const std::vector<ViewPlan>& plans,
                       double distance, double reach, int min_usable) {
  const ViewSelectionOptions options;
  ExpectSoundSelection(plans, options);
  const double end = views.back().CenterInWorld().x();
  for (size_t v = 0; v < plans.size(); ++v) {
    const ViewPlan& plan = plans[v];
    const Vector3d center = views[v].CenterInWorld();
    EXPECT_LT(plan.min_depth, 0.8 * distance) << "view " << v;
    EXPECT_GT(plan.max_depth, 1.2 * distance) << "view " << v;
    EXPECT_GE(plan.second_views.size(), 6u) << "view " << v;
    EXPECT_GE(plan.confirmation_views.size(), 10u) << "view " << v;
    int usable = 0;
    for (const auto* chosen : {&plan.second_views, &plan.confirmation_views}) {
      for (const ViewId other : *chosen) {
        EXPECT_LT(std::abs(views[other].CenterInWorld().x() - center.x()), reach) << "view " << v;
      }
    }
    // Partners on the facade itself: they see what the view sees in its middle.
    const Vector3d middle = Inverse(views[v].cam_from_world) * Vector3d(0, 0, distance);
    for (const ViewId other : plan.confirmation_views) {
      usable += views[other].Project(middle).has_value();
    }
    const bool at_an_end = center.x() < distance || center.x() > end - distance;
    EXPECT_GE(usable, at_an_end ? 2 : min_usable) << "view " << v;
  }
}

TEST(ViewSelectionTest, StreetOfManyViewsIsMatchedAroundEachView) {
  const std::vector<View> views = Street(600, 0.9, 11);
  const SceneHints hints = FacadePoints(views, 0.9, 11);
  ExpectFacadePlans(views, SelectViews(views, hints, ViewSelectionOptions(), {}), 11, 75, 5);
}

TEST(ViewSelectionTest, StreetOfManyViewsNeedsNoPoints) {
  const std::vector<View> views = Street(600, 0.9, 11);
  ExpectFacadePlans(views, SelectViews(views, kNoHints, ViewSelectionOptions(), {}), 11, 200, 2);
}

// What a view is matched with does not depend on how long the street is.
TEST(ViewSelectionTest, FarPartsOfAStreetDoNotMatter) {
  const std::vector<View> all = Street(500, 0.9, 11);
  const std::vector<View> half(all.begin(), all.begin() + 350);
  const auto of_all = SelectViews(all, FacadePoints(all, 0.9, 11), ViewSelectionOptions(), {});
  const auto of_half = SelectViews(half, FacadePoints(half, 0.9, 11), ViewSelectionOptions(), {});
  for (size_t v = 0; v < 200; ++v) {
    EXPECT_EQ(of_all[v].second_views, of_half[v].second_views) << "view " << v;
    EXPECT_EQ(of_all[v].confirmation_views, of_half[v].confirmation_views) << "view " << v;
    EXPECT_EQ(of_all[v].max_depth, of_half[v].max_depth) << "view " << v;
  }
}

// Thinning keeps partners at all usable angles.
TEST(ViewSelectionTest, DenseVideoFindsTheFarPartners) {
  const std::vector<View> views = Turntable(400);
  SceneHints hints;
  for (int i = 0; i < 60; ++i) {
    const Vector3d position(0.5 * std::cos(i), 0.5 * std::sin(i), 0.02 * i - 0.6);
    std::vector<ViewId> seeing;
    for (int v = 0; v < 400; ++v) seeing.push_back(v);
    hints.points.push_back({position, std::move(seeing)});
  }
  for (const SceneHints& with : {kNoHints, hints}) {
    const auto plans = SelectViews(views, with, ViewSelectionOptions(), {});
    ExpectSoundSelection(plans, ViewSelectionOptions());
    for (const size_t v : {size_t{0}, size_t{177}, size_t{399}}) {
      ASSERT_GE(plans[v].second_views.size(), 4u) << "view " << v;
      EXPECT_GE(plans[v].confirmation_views.size(), 8u) << "view " << v;
      const double best = AngleDeg(views[v], views[plans[v].second_views[0]]);
      EXPECT_GE(best, 3) << "view " << v;
      EXPECT_LE(best, 45) << "view " << v;
    }
  }
}

std::vector<ViewId> Primaries(const std::vector<ViewPlan>& plans) {
  std::vector<ViewId> primaries;
  for (size_t v = 0; v < plans.size(); ++v) {
    if (plans[v].is_primary) primaries.push_back(static_cast<ViewId>(v));
  }
  return primaries;
}

TEST(ViewSelectionTest, FewViewsAreAllPrimary) {
  EXPECT_EQ(Primaries(SelectViews(Turntable(20), kNoHints, {}, {})).size(), 20u);
  ViewSelectionOptions options;
  options.enough_primary_views = 200;
  EXPECT_EQ(Primaries(SelectViews(Turntable(150), kNoHints, options, {})).size(), 150u);
}

TEST(ViewSelectionTest, OfManyViewsOfOnePlaceSomeAreSpreadEvenly) {
  // Some 60 of 150 views see the middle under usable angles, fewer what lies before and behind.
  const auto primaries = Primaries(SelectViews(Turntable(150), kNoHints, {}, {}));
  EXPECT_GE(primaries.size(), 40u);
  EXPECT_LE(primaries.size(), 90u);
  for (size_t i = 1; i < primaries.size(); ++i) EXPECT_LE(primaries[i] - primaries[i - 1], 4);
}

// The cameras of a rig that looks to both sides, named in turn.
TEST(ViewSelectionTest, PrimaryViewsAreSpreadOverEveryPlace) {
  const Vector3d there(300, 0, 0);
  std::vector<View> views;
  std::vector<ViewId> here_ids, there_ids;
  for (const View& view : Turntable(100)) {
    here_ids.push_back(static_cast<ViewId>(views.size()));
    views.push_back(view);
    there_ids.push_back(static_cast<ViewId>(views.size()));
    views.push_back(LookAt(view.CenterInWorld() + there, there));
  }
  SceneHints hints;
  for (int i = 0; i < 60; ++i) {
    const Vector3d position(0.5 * std::cos(i), 0.5 * std::sin(i), 0.02 * i - 0.6);
    hints.points.push_back({position, here_ids});
    hints.points.push_back({there + position, there_ids});
  }
  ViewSelectionOptions options;
  options.enough_primary_views = 20;
  const auto primaries = Primaries(SelectViews(views, hints, options, {}));
  const auto num_here =
      std::count_if(primaries.begin(), primaries.end(), [](ViewId v) { return v % 2 == 0; });
  const auto num_there = static_cast<std::ptrdiff_t>(primaries.size()) - num_here;
  for (const auto count : {num_here, num_there}) {
    EXPECT_GE(count, 35);
    EXPECT_LE(count, 75);
  }
}

TEST(ViewSelectionTest, APlaceOfFewViewsKeepsThemAll) {
  std::vector<View> views = Turntable(150);
  for (int i = 0; i < 8; ++i) views.push_back(LookAt({500. + i, -8, 1}, {500. + i, 0, 1}));
  ViewSelectionOptions options;
  options.enough_primary_views = 20;
  const auto primaries = Primaries(SelectViews(views, kNoHints, options, {}));
  EXPECT_GE(primaries.end() - std::lower_bound(primaries.begin(), primaries.end(), 150), 7);
  EXPECT_LE(primaries.size(), 98u);
}

TEST(ViewSelectionTest, BadOptionsThrow) {
  ViewSelectionOptions options;
  options.max_confirmation_views = 33;
  EXPECT_THROW(SelectViews(Turntable(5), kNoHints, options, {}), OptionError);
}

TEST(ViewSelectionTest, AddedViewsArePlannedAsAllAre) {
  const std::vector<View> views = testing::DomeViews(12, 5);
  const auto all = SelectViews(views, {}, {}, {});
  const auto added = PlanAddedViews(views, {}, {3, 8}, std::vector<uint8_t>(12, 1), {}, {});
  ASSERT_EQ(added.size(), views.size());
  for (ViewId v = 0; v < 12; ++v) {
    if (v != 3 && v != 8) {
      EXPECT_FALSE(added[v].is_primary);
      EXPECT_THAT(PartnersIn(added[v]), ::testing::IsEmpty());
      continue;
    }
    EXPECT_TRUE(added[v].is_primary);
    EXPECT_EQ(added[v].second_views, all[v].second_views);
    EXPECT_EQ(added[v].confirmation_views, all[v].confirmation_views);
    EXPECT_EQ(added[v].min_depth, all[v].min_depth);
    EXPECT_EQ(added[v].max_depth, all[v].max_depth);
  }
}

TEST(ViewSelectionTest, AnAddedViewOfWhatEnoughViewsSeeOnlyConfirms) {
  ViewSelectionOptions options;
  options.enough_primary_views = 2;
  const std::vector<View> views = testing::DomeViews(30, 5);
  std::vector<uint8_t> is_sketched(30, 1);
  const auto is_primary = [&] {
    return PlanAddedViews(views, {}, {3}, is_sketched, options, {})[3].is_primary;
  };
  EXPECT_FALSE(is_primary());
  options.enough_primary_views = 29;
  EXPECT_TRUE(is_primary());
  // Views that are not sketched themselves do not count.
  options.enough_primary_views = 2;
  std::fill(is_sketched.begin() + 4, is_sketched.end(), 0);
  EXPECT_TRUE(is_primary());
}

}  // namespace
}  // namespace limn
