// SPDX-License-Identifier: BSD-3-Clause
#include "limn/support/segment_support.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::FrontalPoint;

// Views that look straight down on the plane z = 0, and edges on it, px.
class Scene {
  // The edgels of all views live while the question is asked.
  template <typename Ask>
  auto WithEdgels(Ask&& ask) const {
    std::vector<ImageCurves> curves;
    for (size_t v = 0; v < views.size(); ++v) {
      curves.push_back(testing::ProjectCurves(views[v], shown_[v]));
    }
    return ask(BuildViewEdgels(curves, {}));
  }

 public:
  Scene() : views(testing::FrontalViews(3, 2, 0.75)), shown_(views.size()) {
    visible.assign(views.size(), 1);
  }

  std::vector<ViewId> All() const {
    std::vector<ViewId> all(views.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
  // An edge parallel to the x axis.
  void Show(double from_x, double to_x, double y, const std::vector<ViewId>& in_views) {
    for (const ViewId v : in_views) {
      shown_[v].push_back(testing::Segment(FrontalPoint(from_x, y), FrontalPoint(to_x, y)));
    }
  }
  // What speaks for the segment from (0, 0) to (40, 0).
  SegmentSupport Find() const { return Find(FrontalPoint(0, 0), FrontalPoint(40, 0)); }
  SegmentSupport Find(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    return WithEdgels([&](const auto& edgels) {
      const SegmentSupport found = FindSegmentSupport(from, to, visible, views, edgels, gate);
      // The other question agrees.
      for (const ViewId v : found.seen_in) {
        EXPECT_TRUE(ShowsSegment(views[v], from, to, edgels[v]->edgels, gate));
      }
      return found;
    });
  }
  bool Shows(ViewId view, const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    return WithEdgels([&](const auto& edgels) {
      return ShowsSegment(views[view], from, to, edgels[view]->edgels, gate);
    });
  }

  std::vector<View> views;
  std::vector<uint8_t> visible;
  SupportGate gate = {1.5, 1.0, 0.4};

 private:
  std::vector<std::vector<testing::SceneCurve>> shown_;
};

using Ids = std::vector<ViewId>;

TEST(FindSegmentSupportTest, ViewsThatShowTheSegmentAreFound) {
  Scene scene;
  scene.Show(0, 40, 0, {1, 4, 5});
  const SegmentSupport found = scene.Find();
  EXPECT_EQ(found.seen_in, (Ids{1, 4, 5}));
  EXPECT_EQ(found.num_views, 6);
}

TEST(FindSegmentSupportTest, OnlyVisibleViewsAreAsked) {
  Scene scene;
  scene.Show(0, 40, 0, {1, 4, 5});
  scene.visible = {1, 1, 0, 0, 0, 1};
  EXPECT_EQ(scene.Find().seen_in, (Ids{1, 5}));
  EXPECT_EQ(scene.Find().num_views, 3);
  scene.visible = {1, 0, 1, 1, 0, 0};
  EXPECT_TRUE(scene.Find().seen_in.empty());
}

TEST(FindSegmentSupportTest, MostOfTheSegmentMustBeCovered) {
  const auto seen = [](double covered_px) {
    Scene scene;
    scene.Show(0, covered_px, 0, scene.All());
    return scene.Find().seen_in.size();
  };
  EXPECT_EQ(seen(30), 6u);
  EXPECT_EQ(seen(25), 0u);
}

TEST(FindSegmentSupportTest, RoundedEndsAreNotMissed) {
  Scene scene;
  scene.Show(2.4, 4.6, 0, scene.All());
  EXPECT_EQ(scene.Find(FrontalPoint(0, 0), FrontalPoint(7, 0)).seen_in.size(), 6u);
}

TEST(FindSegmentSupportTest, EdgelsAreWithinTheGate) {
  const auto seen = [](double y, const SupportGate& gate) {
    Scene scene;
    scene.gate = gate;
    scene.Show(-10, 50, y, scene.All());
    return scene.Find().seen_in.size();
  };
  EXPECT_EQ(seen(1.4, {1.5, 1, 0.4}), 6u);
  EXPECT_EQ(seen(1.6, {1.5, 1, 0.4}), 0u);
  EXPECT_EQ(seen(1.6, {1.7, 1, 0.4}), 6u);
}

TEST(FindSegmentSupportTest, EdgelsRunAlongTheSegment) {
  // A ladder without rails.
  Scene scene;
  for (int y = 0; y <= 40; ++y) scene.Show(-1, 1, y, scene.All());
  EXPECT_TRUE(scene.Find(FrontalPoint(0, 0), FrontalPoint(0, 40)).seen_in.empty());
  scene.gate.angle_rad = 2;
  EXPECT_EQ(scene.Find(FrontalPoint(0, 0), FrontalPoint(0, 40)).seen_in.size(), 6u);
}

TEST(FindSegmentSupportTest, ViewsThatCannotShowItDoNotCount) {
  Scene scene;
  scene.Show(0, 40, 0, scene.All());
  // Too short in all of them.
  EXPECT_EQ(scene.Find(FrontalPoint(10, 0), FrontalPoint(12.9, 0)).num_views, 0);
  EXPECT_EQ(scene.Find(FrontalPoint(10, 0), FrontalPoint(13.1, 0)).num_views, 6);
  // Seen end on by the first one.
  const Eigen::Vector3d center = scene.views[0].CenterInWorld();
  const Eigen::Vector3d from = FrontalPoint(20, 0);
  const Eigen::Vector3d to = from + 0.1 * (center - from);
  EXPECT_EQ(scene.Find(from, to).num_views, 5);
  EXPECT_FALSE(scene.Shows(0, from, to));
  // One end outside of the images of the two views on the left.
  EXPECT_EQ(scene.Find(FrontalPoint(0, 0), FrontalPoint(300, 0)).num_views, 4);
}

TEST(FindSegmentSupportTest, BackgroundIsTheShareOfCopiesWithEdgels) {
  const auto background = [](const std::vector<double>& ys, const Ids& in_views) {
    Scene scene;
    for (const double y : ys) scene.Show(-10, 50, y, in_views);
    return scene.Find().background;
  };
  const Ids all = Scene().All();
  // Nothing, and the edge itself: no background is quite empty.
  EXPECT_EQ(background({}, all), 0.02);
  EXPECT_EQ(background({0}, all), 0.02);
  // Of six copies one, in all views and in half of them, and all.
  EXPECT_NEAR(background({0, 9}, all), 1.0 / 6, 1e-9);
  EXPECT_NEAR(background({9}, {0, 2, 4}), 1.0 / 12, 1e-9);
  EXPECT_NEAR(background({-9, -7, -5, 5, 7, 9}, all), 1, 1e-9);
  // Where nobody can be asked all is chance.
  Scene none;
  none.visible.assign(6, 0);
  EXPECT_EQ(none.Find().background, 1);
}

TEST(FindSegmentSupportTest, SeesTrueEdgesAndNoOthers) {
  const auto views = testing::DomeViews(16, 5);
  const auto edges = testing::CubeEdges(0.2);
  const auto curves = testing::ProjectCurves(views, edges);
  const auto edgels = BuildViewEdgels(curves, {});
  const Eigen::Vector3d from = edges.front().points.front();
  const Eigen::Vector3d to = edges.front().points.back();
  const std::vector<uint8_t> all(views.size(), 1);
  const SupportGate gate{1.5, 1.5, 0.4};
  const SegmentSupport seen = FindSegmentSupport(from, to, all, views, edgels, gate);
  EXPECT_EQ(seen.num_views, 16);
  EXPECT_EQ(seen.seen_in.size(), 16u);
  EXPECT_LT(seen.background, 0.2);
  // A diagonal through the empty cube.
  EXPECT_LE(FindSegmentSupport(from, -from, all, views, edgels, gate).seen_in.size(), 1u);
}

TEST(LogChanceTest, ValuesByHand) {
  EXPECT_NEAR(LogChance(10, 10, 0.1), 10 * std::log(0.1), 1e-12);
  // 10 (0.5 log(0.5 / 0.25) + 0.5 log(0.5 / 0.75)) = 5 log(4 / 3)
  EXPECT_NEAR(LogChance(5, 10, 0.25), -5 * std::log(4.0 / 3), 1e-12);
  // 4 (0.75 log(0.75 / 0.5) + 0.25 log(0.25 / 0.5)) = 3 log(1.5) - log(2)
  EXPECT_NEAR(LogChance(3, 4, 0.5), -(3 * std::log(1.5) - std::log(2.0)), 1e-12);
}

TEST(LogChanceTest, WhatOneExpectsIsNoSurprise) {
  EXPECT_EQ(LogChance(2, 20, 0.1), 0);
  EXPECT_EQ(LogChance(1, 20, 0.1), 0);
  EXPECT_LT(LogChance(3, 20, 0.1), 0);
  EXPECT_EQ(LogChance(0, 0, 0.1), 0);
  EXPECT_EQ(LogChance(7, 7, 1), 0);
}

TEST(LogChanceTest, FallsWithTheViewsAndRisesWithTheBackground) {
  for (int k = 3; k < 12; ++k) EXPECT_LT(LogChance(k + 1, 12, 0.2), LogChance(k, 12, 0.2));
  for (double p = 0.05; p < 0.4; p += 0.05) {
    EXPECT_LT(LogChance(6, 12, p), LogChance(6, 12, p + 0.05));
  }
  // At the same share, more views are stronger evidence, up to the number that is independent.
  for (int n = 4; n < kIndependentViews; n += 2) {
    EXPECT_GT(LogChance(n / 2, n, 0.1), LogChance(n / 2 + 1, n + 2, 0.1));
  }
  EXPECT_EQ(LogChance(kIndependentViews / 2, kIndependentViews, 0.1),
            LogChance(5 * kIndependentViews, 10 * kIndependentViews, 0.1));
  EXPECT_NEAR(LogChance(1000, 1000, 0.1), kIndependentViews * std::log(0.1), 1e-9);
}

// P(at least k of n) for independent trials.
double BinomialTail(int k, int n, double p) {
  double sum = 0;
  for (int i = k; i <= n; ++i) {
    sum += std::exp(std::lgamma(n + 1) - std::lgamma(i + 1) - std::lgamma(n - i + 1) +
                    i * std::log(p) + (n - i) * std::log(1 - p));
  }
  return sum;
}

TEST(LogChanceTest, BoundsTheBinomialTail) {
  for (const int num_views : {kIndependentViews, 20}) {
    for (const double p : {0.02, 0.1, 0.3}) {
      for (int k = 1; k <= num_views; ++k) {
        EXPECT_GE(LogChance(k, num_views, p), std::log(BinomialTail(k, num_views, p)) - 1e-9)
            << k << " " << p;
        EXPECT_LE(LogChance(k, num_views, p), LogChance(k - 1, num_views, p));
      }
    }
  }
}

}  // namespace
}  // namespace limn
