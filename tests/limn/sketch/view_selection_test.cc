#include "limn/sketch/view_selection.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using Eigen::Vector3d;
using testing::LookAt;

const SceneHints kNoHints;

// Angle at the origin between two cameras.
double AngleDeg(const View& a, const View& b) {
  const Vector3d u = a.CenterInWorld().normalized(), v = b.CenterInWorld().normalized();
  return std::acos(std::clamp(u.dot(v), -1.0, 1.0)) * 180 / M_PI;
}

// Cameras at equal steps once around the origin.
std::vector<View> Turntable(int count) {
  std::vector<View> views;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * i / count;
    views.push_back(LookAt({5 * std::cos(angle), 5 * std::sin(angle), 2}, {0, 0, 0}));
  }
  return views;
}

void ExpectSound(const std::vector<ViewPlan>& plans, const ViewSelectionOptions& options) {
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

TEST(ViewSelectionTest, TurntableMatchesNeighboursAndCoversTheScene) {
  const std::vector<View> views = Turntable(36);
  const ViewSelectionOptions options;
  const std::vector<ViewPlan> plans = SelectViews(views, kNoHints, options, {});
  ASSERT_EQ(plans.size(), views.size());
  ExpectSound(plans, options);
  const double distance = views[0].CenterInWorld().norm();
  for (size_t v = 0; v < views.size(); ++v) {
    EXPECT_LT(plans[v].min_depth, distance - 1) << "view " << v;
    EXPECT_GT(plans[v].max_depth, distance + 1) << "view " << v;
    EXPECT_GE(plans[v].second_views.size(), 4u) << "view " << v;
    EXPECT_GE(plans[v].confirmation_views.size(), 6u) << "view " << v;
    // The best second view is a usable neighbour on the arc.
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

TEST(ViewSelectionTest, CamerasAtOneCentreAreAnInputError) {
  std::vector<View> views;
  for (int i = 0; i < 5; ++i) {
    views.push_back(LookAt({0, 0, 0}, {5 * std::cos(0.3 * i), 5 * std::sin(0.3 * i), 1}));
  }
  EXPECT_THROW(SelectViews(views, kNoHints, ViewSelectionOptions(), {}), InputError);
}

// The same away from the world's origin, where the centres agree only up to rounding.
TEST(ViewSelectionTest, CamerasAtOneCentreElsewhereAreAnInputError) {
  std::vector<View> views;
  for (int i = 0; i < 5; ++i) {
    const Vector3d centre(3.1, -2.7, 1.3);
    views.push_back(
        LookAt(centre, centre + Vector3d(5 * std::cos(0.3 * i), 5 * std::sin(0.3 * i), 1)));
  }
  EXPECT_THROW(SelectViews(views, kNoHints, ViewSelectionOptions(), {}), InputError);
}

TEST(ViewSelectionTest, OptionsBoundTheSelections) {
  ViewSelectionOptions options;
  options.max_second_views = 3;
  options.max_confirmation_views = 5;
  const std::vector<ViewPlan> plans = SelectViews(testing::DomeViews(30, 5), kNoHints, options, {});
  ExpectSound(plans, options);
  for (const ViewPlan& plan : plans) {
    EXPECT_EQ(plan.second_views.size(), 3u);
    EXPECT_EQ(plan.confirmation_views.size(), 5u);
  }
}

TEST(ViewSelectionTest, VideoPicksSpreadViews) {
  // 240 frames at steps of half a degree: the neighbours are useless as partners.
  std::vector<View> views;
  for (int i = 0; i < 240; ++i) {
    const double angle = 0.5 * i * M_PI / 180;
    views.push_back(LookAt({5 * std::cos(angle), 5 * std::sin(angle), 2}, {0, 0, 0}));
  }
  const ViewSelectionOptions options;
  const std::vector<ViewPlan> plans = SelectViews(views, kNoHints, options, {});
  ExpectSound(plans, options);
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

TEST(ViewSelectionTest, BadOptionsThrow) {
  ViewSelectionOptions options;
  options.max_confirmation_views = 33;
  EXPECT_THROW(SelectViews(Turntable(5), kNoHints, options, {}), OptionError);
}

}  // namespace
}  // namespace limn
