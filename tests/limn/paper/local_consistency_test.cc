// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/local_consistency.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

namespace limn {
namespace {

using Eigen::Vector3d;

constexpr int kNumSceneViews = 8;

struct Sample {
  std::vector<EdgelRef> support;
  Vector3d position = Vector3d::Zero();
};

// Samples of curves and the edgels that support them.
class Scene {
 public:
  // Returns the id of its first sample.
  int AddCurve(ViewId anchor, const std::vector<Sample>& of_curve) {
    const int first = samples.NumSamples();
    const int curve = samples.NumCurves();
    samples.origins.push_back({curve, 0, anchor, false});
    for (const Sample& sample : of_curve) {
      samples.curve_of.push_back(curve);
      samples.position.push_back(sample.position);
      samples.tangent.push_back(Vector3d::UnitX());
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
    return BuildLocalConsistency(samples, kNumSceneViews, options, context);
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
  PaperOptions options;
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

// Whatever else supports them.
TEST(LocalConsistencyTest, SamplesThatShareEdgelsAreLinked) {
  Scene scene;
  const int a = scene.AddCurve(0, {{Joined(In({0, 1, 2}, 5), In({3, 4, 5, 6}, 5))}});
  const int b = scene.AddCurve(1, {{Joined(In({0, 1, 2}, 5), In({3, 4, 5, 6}, 45))}});
  EXPECT_EQ(scene.LinksOf(a), (Links{{b, 3}}));
  EXPECT_EQ(scene.LinksOf(b), (Links{{a, 3}}));
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
