#include "limn/paper/local_consistency.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn {
namespace {

using Eigen::Vector3d;

constexpr int kNumSceneViews = 8;
constexpr int kRowLength = 40;

struct Sample {
  std::vector<EdgelRef> support;
  Vector3d position = Vector3d::Zero();
  Vector3d tangent = Vector3d::UnitX();
};

// Samples of curves and the edgels that support them. Every view has the same rows of edgels that
// run along x: edgel `row * kRowLength + i` is at pixel (100 + i, 100 + row * row_distance_px).
class Scene {
 public:
  explicit Scene(double row_distance_px = 50) {
    std::vector<Edgel> edgels;
    for (int row = 0; row < 2; ++row) {
      for (int i = 0; i < kRowLength; ++i) {
        edgels.push_back(testing::MakeEdgel({100.0 + i, 100 + row * row_distance_px}, 0));
      }
    }
    const View view = testing::LookAt({5, 0, 0}, Vector3d::Zero());
    for (int v = 0; v < kNumSceneViews; ++v) {
      curves.emplace_back();
      curves.back().edge_map = testing::MakeEdgeMap(view, edgels);
    }
  }

  // Returns the id of its first sample.
  int AddCurve(ViewId anchor, const std::vector<Sample>& of_curve) {
    const int first = samples.NumSamples();
    const int curve = samples.NumCurves();
    samples.origins.push_back({curve, 0, anchor, false});
    for (const Sample& sample : of_curve) {
      samples.curve_of.push_back(curve);
      samples.position.push_back(sample.position);
      samples.tangent.push_back(sample.tangent);
      samples.information.push_back(Eigen::Matrix3d::Identity());
      samples.footprint.push_back(1);
      samples.support.Append(sample.support);
    }
    samples.curve_begin.push_back(samples.NumSamples());
    return first;
  }

  LocalConsistency Build(int num_threads = 1) const {
    RunContext context;
    context.num_threads = num_threads;
    return BuildLocalConsistency(samples, curves, options, context);
  }

  // Votes by the other sample.
  std::map<int, int> LinksOf(int sample) const {
    const LocalConsistency network = Build();
    std::map<int, int> links;
    for (const SampleLink& link : network.at(samples.curve_of.at(sample))) {
      if (link.sample != sample) continue;
      EXPECT_TRUE(links.emplace(link.other, link.votes).second);
    }
    return links;
  }

  SampleSet samples;
  std::vector<ImageCurves> curves;
  DrawingOptions options;
};

using Links = std::map<int, int>;

// The same edgel in each of these views.
std::vector<EdgelRef> In(const std::vector<ViewId>& views, EdgelId edgel) {
  std::vector<EdgelRef> support;
  for (const ViewId v : views) support.push_back({v, edgel});
  return support;
}

std::vector<EdgelRef> Joined(std::vector<EdgelRef> a, const std::vector<EdgelRef>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  return a;
}

TEST(LocalConsistencyTest, VotesAreTheViewsThatShareAnEdgel) {
  Scene scene;
  const int a = scene.AddCurve(0, {{In({0, 1, 2, 3, 4, 5, 6}, 5)}});
  const int b = scene.AddCurve(1, {{Joined(In({0, 2, 3, 5}, 5), In({1, 6}, 6))}});
  EXPECT_EQ(scene.LinksOf(a), (Links{{b, 4}}));
  EXPECT_EQ(scene.LinksOf(b), (Links{{a, 4}}));
}

// The paper links what shares edgels, whatever the direction and what else supports it.
TEST(LocalConsistencyTest, ThePaperRejectsNoLinks) {
  Scene scene(3);
  scene.options.method = "paper";
  // They share an edgel in three views, and have edgels side by side in four.
  const int a = scene.AddCurve(0, {{Joined(In({0, 1, 2}, 5), In({3, 4, 5, 6}, 5))}});
  const int b = scene.AddCurve(
      1, {{Joined(In({0, 1, 2}, 5), In({3, 4, 5, 6}, kRowLength + 5)), {}, Vector3d::UnitY()}});
  EXPECT_EQ(scene.LinksOf(a), (Links{{b, 3}}));
  EXPECT_EQ(scene.LinksOf(b), (Links{{a, 3}}));
  scene.options.method = "merged";
  EXPECT_EQ(scene.LinksOf(a), Links());
}

TEST(LocalConsistencyTest, StrongLinksOfASampleAreCounted) {
  // Three views share edgels with two samples of the other curve, two with a third one.
  Scene scene;
  scene.options.dense_link_views = 2;
  scene.AddCurve(0, {{In({0, 1, 2, 3}, 5)}});
  scene.AddCurve(1, {{In({0, 1, 2}, 5)}, {In({1, 2, 3}, 5)}, {In({2, 3}, 5)}});
  const LocalConsistency network = scene.Build();
  ASSERT_EQ(network[0].size(), 1u);
  EXPECT_EQ(network[0][0].votes, 3);
  EXPECT_EQ(network[0][0].num_strong, 2);
  ASSERT_EQ(network[1].size(), 3u);
  EXPECT_EQ(network[1][0].num_strong, 1);
  EXPECT_EQ(network[1][2].num_strong, 0);
}

TEST(LocalConsistencyTest, TheSameEdgelIdInAnotherViewIsAnotherEdgel) {
  Scene scene;
  const int a = scene.AddCurve(0, {{In({0, 1, 2}, 5)}});
  scene.AddCurve(1, {{In({3, 4, 5}, 5)}});
  EXPECT_EQ(scene.LinksOf(a), Links());
}

TEST(LocalConsistencyTest, NoLinkBelowDenseLinkViews) {
  Scene scene;
  const int a = scene.AddCurve(0, {{In({0, 1, 2, 3}, 5)}});
  const int three = scene.AddCurve(1, {{In({1, 2, 3}, 5)}});
  const int two = scene.AddCurve(2, {{In({2, 3, 4, 5}, 5)}});
  scene.options.dense_link_views = 3;
  scene.options.strong_link_views = 5;  // decides nothing here
  EXPECT_EQ(scene.LinksOf(a), (Links{{three, 3}}));
  scene.options.dense_link_views = 2;
  EXPECT_EQ(scene.LinksOf(a), (Links{{three, 3}, {two, 2}}));
  scene.options.dense_link_views = 4;
  EXPECT_EQ(scene.LinksOf(a), Links());
}

TEST(LocalConsistencyTest, CurvesOfOneViewAreNeverLinked) {
  Scene scene;
  const int a = scene.AddCurve(3, {{In({0, 1, 2, 3}, 5)}, {In({0, 1, 2, 3}, 5)}});
  scene.AddCurve(3, {{In({0, 1, 2, 3}, 5)}});
  const int other = scene.AddCurve(4, {{In({0, 1, 2, 3}, 5)}});
  EXPECT_EQ(scene.LinksOf(a), (Links{{other, 4}}));
}

TEST(LocalConsistencyTest, SampleWithMostVotesIsTheLink) {
  Scene scene;
  const int a = scene.AddCurve(0, {{In({0, 1, 2, 3, 4}, 5)}});
  const Sample few{In({0, 1, 2}, 5), {0.1, 0, 0}};
  const Sample many{In({0, 1, 2, 3}, 5), {9, 0, 0}};
  const int b = scene.AddCurve(1, {few, many, few});
  const int c = scene.AddCurve(2, {many, few});
  const int d = scene.AddCurve(3, {few, many});
  EXPECT_EQ(scene.LinksOf(a), (Links{{b + 1, 4}, {c, 4}, {d + 1, 4}}));
}

TEST(LocalConsistencyTest, OfEqualVotesTheNearestIsTheLink) {
  Scene scene;
  const Vector3d position(3, -1, 2);
  const int a = scene.AddCurve(0, {{In({0, 1, 2, 3}, 5), position}});
  const Sample near{In({0, 1, 2}, 5), position + Vector3d(0, 0, 0.5)};
  const Sample far{In({1, 2, 3}, 5), position - Vector3d(0.6, 0, 0)};
  const int b = scene.AddCurve(1, {far, near, far});
  const int c = scene.AddCurve(2, {near, far});
  const int d = scene.AddCurve(3, {far, near});
  EXPECT_EQ(scene.LinksOf(a), (Links{{b + 1, 3}, {c, 3}, {d + 1, 3}}));
}

// Samples at this angle to the first one.
Links LinksAtAngle(double angle_deg, double max_angle_deg) {
  Scene scene;
  scene.options.max_link_angle_deg = max_angle_deg;
  const double angle = angle_deg * M_PI / 180;
  const int a = scene.AddCurve(0, {{In({0, 1, 2}, 5)}});
  scene.AddCurve(1, {{In({0, 1, 2}, 5), Vector3d::Zero(), {std::cos(angle), 0, std::sin(angle)}}});
  return scene.LinksOf(a);
}

TEST(LocalConsistencyTest, DirectionsDifferByAtMostMaxLinkAngle) {
  for (const double max_angle_deg : {10.0, 25.0, 60.0}) {
    for (const double sign : {-1.0, 1.0}) {
      EXPECT_EQ(LinksAtAngle(sign * (max_angle_deg - 0.1), max_angle_deg), (Links{{1, 3}}));
      EXPECT_EQ(LinksAtAngle(sign * (max_angle_deg + 0.1), max_angle_deg), Links());
      // Curves have no sense of direction.
      EXPECT_EQ(LinksAtAngle(180 + sign * (max_angle_deg - 0.1), max_angle_deg), (Links{{1, 3}}));
      EXPECT_EQ(LinksAtAngle(180 + sign * (max_angle_deg + 0.1), max_angle_deg), Links());
    }
  }
}

TEST(LocalConsistencyTest, SampleInAnotherDirectionDoesNotHideOneThatAgrees) {
  Scene scene;
  const int a = scene.AddCurve(0, {{In({0, 1, 2, 3}, 5)}});
  const Sample across{In({0, 1, 2, 3}, 5), Vector3d::Zero(), Vector3d::UnitZ()};
  const Sample along{In({0, 1, 2}, 5), {2, 0, 0}};
  const int b = scene.AddCurve(1, {across, along});
  EXPECT_EQ(scene.LinksOf(a), (Links{{b + 1, 3}}));
}

// Two samples on the same edgel in `num_shared` views, and on edgels of either row in `num_apart`
// views.
Links LinksOfTwoBars(const Scene& bars, int num_shared, int num_apart) {
  Scene scene = bars;
  std::vector<EdgelRef> a, b;
  for (int v = 0; v < num_shared + num_apart; ++v) {
    a.push_back({v, 5});
    b.push_back({v, v < num_shared ? 5 : kRowLength + 5});
  }
  scene.AddCurve(0, {{a}});
  scene.AddCurve(1, {{b}});
  const Links links = scene.LinksOf(0);
  EXPECT_EQ(scene.LinksOf(1).size(), links.size());
  return links;
}

TEST(LocalConsistencyTest, EdgelsSideBySideInAsManyViewsAsAgreeLeaveTheLinkOut) {
  for (const double apart_px : {-1.5, 1.5, 4.0}) {
    const Scene bars(apart_px);
    EXPECT_EQ(LinksOfTwoBars(bars, 3, 2), (Links{{1, 3}}));
    EXPECT_EQ(LinksOfTwoBars(bars, 3, 3), Links());
    EXPECT_EQ(LinksOfTwoBars(bars, 3, 5), Links());
    EXPECT_EQ(LinksOfTwoBars(bars, 4, 3), (Links{{1, 4}}));
    EXPECT_EQ(LinksOfTwoBars(bars, 4, 4), Links());
  }
}

TEST(LocalConsistencyTest, EdgelsWithinAPixelAreNotSideBySide) {
  EXPECT_EQ(LinksOfTwoBars(Scene(0.5), 3, 5), (Links{{1, 3}}));
  EXPECT_EQ(LinksOfTwoBars(Scene(-0.5), 3, 5), (Links{{1, 3}}));
}

TEST(LocalConsistencyTest, SideBySideIsMeasuredInTheStoredImage) {
  Scene scene(0.75);
  EXPECT_EQ(LinksOfTwoBars(scene, 3, 5), (Links{{1, 3}}));
  for (ImageCurves& of_view : scene.curves) {
    for (Edgel& edgel : of_view.edge_map.edgels) edgel.stored_from_virtual *= 2;
  }
  EXPECT_EQ(LinksOfTwoBars(scene, 3, 5), Links());
}

TEST(LocalConsistencyTest, EdgelsAlongTheEdgeAreNotSideBySide) {
  Scene scene;
  const int a = scene.AddCurve(0, {{In({0, 1, 2, 3, 4, 5}, 5)}});
  const int b = scene.AddCurve(1, {{Joined(In({0, 1, 2}, 5), In({3, 4, 5}, 15))}});
  EXPECT_EQ(scene.LinksOf(a), (Links{{b, 3}}));
}

TEST(LocalConsistencyTest, ViewsOfOneSampleAloneAreNotCompared) {
  const EdgelId other_row = kRowLength + 5;
  Scene scene(3);
  // Both in views 0, 4, 6 (the same edgel) and 3, 7 (side by side).
  const int a = scene.AddCurve(0, {{In({0, 1, 3, 4, 6, 7}, 5)}});
  const int b = scene.AddCurve(1, {{Joined(In({0, 4, 6}, 5), In({2, 3, 5, 7}, other_row))}});
  EXPECT_EQ(scene.LinksOf(a), (Links{{b, 3}}));
  EXPECT_EQ(scene.LinksOf(b), (Links{{a, 3}}));
  // Again 0, 4, 6, but three side by side: 2, 5, 7.
  Scene apart(3);
  const int c = apart.AddCurve(0, {{In({0, 1, 2, 4, 5, 6, 7}, 5)}});
  const int d = apart.AddCurve(1, {{Joined(In({0, 4, 6}, 5), In({2, 3, 5, 7}, other_row))}});
  EXPECT_EQ(apart.LinksOf(c), Links());
  EXPECT_EQ(apart.LinksOf(d), Links());
}

TEST(LocalConsistencyTest, LinksAscendByCurveAndEveryCurveHasItsPlace) {
  Scene scene;
  const Sample lonely{In({5, 6, 7}, 30)};
  const Sample shared{In({0, 1, 2}, 5)};
  const Sample further{In({0, 1, 2}, 5), {1, 0, 0}};
  scene.AddCurve(4, {lonely, shared});           // 0, 1
  scene.AddCurve(3, {{}, {}});                   // 2, 3: no support at all
  scene.AddCurve(2, {shared, lonely, further});  // 4, 5, 6
  scene.AddCurve(1, {shared});                   // 7
  scene.AddCurve(0, {{In({2, 3, 4}, 6)}, {}});   // 8, 9
  for (const int num_threads : {1, 3}) {
    const LocalConsistency network = scene.Build(num_threads);
    ASSERT_EQ(network.size(), 5u);
    std::vector<int> of_samples, others, votes;
    for (size_t c = 0; c < network.size(); ++c) {
      for (const SampleLink& link : network[c]) {
        EXPECT_EQ(scene.samples.curve_of.at(link.sample), static_cast<int>(c));
        of_samples.push_back(link.sample);
        others.push_back(link.other);
        votes.push_back(link.votes);
      }
    }
    EXPECT_EQ(of_samples, (std::vector<int>{0, 1, 1, 4, 4, 5, 6, 6, 7, 7}));
    EXPECT_EQ(others, (std::vector<int>{5, 4, 7, 1, 7, 0, 1, 7, 1, 4}));
    EXPECT_EQ(votes, std::vector<int>(10, 3));
  }
}

TEST(LocalConsistencyTest, NothingOfNothing) {
  Scene scene;
  EXPECT_TRUE(scene.Build().empty());
  scene.AddCurve(0, {{}, {}});
  const LocalConsistency network = scene.Build();
  ASSERT_EQ(network.size(), 1u);
  EXPECT_TRUE(network[0].empty());
}

}  // namespace
}  // namespace limn
