// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/curve_consistency.h"

#include <map>
#include <numeric>

#include <gtest/gtest.h>

#include "limn/drawing/sample_curves.h"

namespace limn {
namespace {

std::vector<double> UnitArc(size_t count) {
  std::vector<double> arc(count);
  std::iota(arc.begin(), arc.end(), 0.0);
  return arc;
}

// Partner 100 + k at every k in [begin, end) of these ranges, -1 elsewhere.
std::vector<int> Partners(size_t count, const std::vector<std::pair<int, int>>& ranges) {
  std::vector<int> partner(count, -1);
  for (const auto& [begin, end] : ranges) {
    for (int k = begin; k < end; ++k) partner[k] = 100 + k;
  }
  return partner;
}

TEST(RegularizeOverlapTest, FillsGapUpToMaxGapByInterpolation) {
  std::vector<int> partner = Partners(60, {{0, 20}, {26, 60}});
  RegularizeOverlap(UnitArc(60), 7, &partner);
  EXPECT_EQ(partner, Partners(60, {{0, 60}}));
}

TEST(RegularizeOverlapTest, InterpolatesDescendingPartners) {
  std::vector<int> partner(40);
  for (int k = 0; k < 40; ++k) partner[k] = 200 - k;
  const std::vector<int> full = partner;
  for (int k = 10; k < 14; ++k) partner[k] = -1;
  RegularizeOverlap(UnitArc(40), 9, &partner);
  EXPECT_EQ(partner, full);
}

TEST(RegularizeOverlapTest, KeepsLongerGap) {
  const std::vector<int> before = Partners(80, {{0, 30}, {45, 80}});
  std::vector<int> partner = before;
  RegularizeOverlap(UnitArc(80), 9, &partner);
  EXPECT_EQ(partner, before);
}

TEST(RegularizeOverlapTest, GapIsMeasuredInArcLengthNotSamples) {
  std::vector<double> arc = UnitArc(40);
  for (double& a : arc) a *= 3;
  const std::vector<int> before = Partners(40, {{0, 18}, {22, 40}});  // 15 long, 4 samples
  std::vector<int> partner = before;
  RegularizeOverlap(arc, 9, &partner);
  EXPECT_EQ(partner, before);
}

TEST(RegularizeOverlapTest, RemovesShortRunInside) {
  std::vector<int> partner = Partners(100, {{0, 30}, {45, 49}, {65, 100}});
  RegularizeOverlap(UnitArc(100), 9, &partner);
  EXPECT_EQ(partner, Partners(100, {{0, 30}, {65, 100}}));
}

TEST(RegularizeOverlapTest, RemovesShortRunsAtBothEnds) {
  std::vector<int> partner = Partners(100, {{0, 4}, {30, 60}, {96, 100}});
  RegularizeOverlap(UnitArc(100), 9, &partner);
  EXPECT_EQ(partner, Partners(100, {{30, 60}}));
}

TEST(RegularizeOverlapTest, DoesNotExtendToTheEnds) {
  const std::vector<int> before = Partners(100, {{3, 97}});
  std::vector<int> partner = before;
  RegularizeOverlap(UnitArc(100), 9, &partner);
  EXPECT_EQ(partner, before);
}

TEST(RegularizeOverlapTest, ShortRunsNearEachOtherJoinBeforeTheyAreJudged) {
  std::vector<int> partner = Partners(100, {{40, 45}, {50, 55}});
  RegularizeOverlap(UnitArc(100), 9, &partner);
  EXPECT_EQ(partner, Partners(100, {{40, 55}}));
}

TEST(RegularizeOverlapTest, LessIsAskedOfShortCurves) {
  const std::vector<int> before = Partners(11, {{3, 10}});  // 6 of 10, but less than 9
  std::vector<int> partner = before;
  RegularizeOverlap(UnitArc(11), 9, &partner);
  EXPECT_EQ(partner, before);
}

TEST(RegularizeOverlapTest, NothingStaysNothing) {
  std::vector<int> partner(20, -1);
  RegularizeOverlap(UnitArc(20), 9, &partner);
  EXPECT_EQ(partner, std::vector<int>(20, -1));
}

TEST(RegularizeOverlapTest, RunOfJustTheLengthNeededStays) {
  const std::vector<int> before = Partners(100, {{20, 30}, {50, 59}});  // 9 and 8 long
  std::vector<int> partner = before;
  RegularizeOverlap(UnitArc(100), 9, &partner);
  EXPECT_EQ(partner, Partners(100, {{20, 30}}));
}

TEST(RegularizeOverlapTest, RunIsMeasuredInArcLengthNotSamples) {
  std::vector<double> arc = UnitArc(100);
  for (double& a : arc) a *= 3;
  const std::vector<int> before = Partners(100, {{40, 44}});  // 9 long
  std::vector<int> partner = before;
  RegularizeOverlap(arc, 9, &partner);
  EXPECT_EQ(partner, before);
}

// Curves of 60 samples a pixel apart, and what the local network says of them.
class NetworkScene {
 public:
  static constexpr int kSize = 60;

  explicit NetworkScene(int num_curves) : votes_(num_curves * kSize) {
    std::vector<std::vector<Eigen::Vector3d>> curves;
    for (int c = 0; c < num_curves; ++c) {
      curves.push_back(testing::Row({0, 10.0 * c, 0}, {1, 0, 0}, kSize));
    }
    samples = testing::MakeSamples(curves);
  }

  // Samples [begin, end) of curve `from` are linked to those of the same number of curve `to`.
  void Link(int from, int to, int begin, int end, int votes) {
    for (int k = begin; k < end; ++k) votes_[from * kSize + k][to * kSize + k] = votes;
  }

  CurveConsistency Build() const {
    LocalConsistency network(samples.NumCurves());
    for (int s = 0; s < samples.NumSamples(); ++s) {
      for (const auto& [other, votes] : votes_[s]) {
        network[s / kSize].push_back({s, other, votes, votes >= options.strong_link_views});
      }
    }
    return BuildCurveConsistency(samples, network, options, {});
  }

  // Curves that a curve overlaps.
  static std::vector<int> Others(const CurveConsistency& network, int curve) {
    std::vector<int> others;
    for (const CurveOverlap& overlap : network.overlaps.at(curve)) {
      EXPECT_EQ(overlap.partner.size(), static_cast<size_t>(kSize));
      others.push_back(overlap.other);
    }
    return others;
  }

  // Partners of the same number of curve `to` in these ranges, -1 elsewhere.
  static std::vector<int> PartnersOn(int to, const std::vector<std::pair<int, int>>& ranges) {
    std::vector<int> partner(kSize, -1);
    for (const auto& [begin, end] : ranges) {
      for (int k = begin; k < end; ++k) partner[k] = to * kSize + k;
    }
    return partner;
  }

  SampleSet samples;
  PaperOptions options;

 private:
  std::vector<std::map<int, int>> votes_;  // per sample: by other sample
};

using Others = std::vector<int>;

TEST(CurveConsistencyTest, DenseLinksJoinTheOverlapButDoNotMakeOne) {
  NetworkScene scene(3);
  scene.options.strong_link_views = 4;
  scene.Link(0, 1, 10, 50, 3);
  scene.Link(0, 2, 10, 50, 3);
  scene.Link(0, 2, 30, 36, 4);
  const CurveConsistency network = scene.Build();
  ASSERT_EQ(NetworkScene::Others(network, 0), Others{2});
  EXPECT_EQ(network.overlaps[0][0].partner, NetworkScene::PartnersOn(2, {{10, 50}}));
  EXPECT_EQ(network.num_clusters, 2);
}

// However short they are together.
TEST(CurveConsistencyTest, TheNumberOfStrongLinksCounts) {
  NetworkScene scene(3);
  for (const int other : {1, 2}) scene.Link(0, other, 10, 50, 2);
  scene.Link(0, 1, 20, 24, 3);
  scene.Link(0, 2, 20, 25, 3);
  EXPECT_EQ(NetworkScene::Others(scene.Build(), 0), Others{2});
  scene.options.min_strong_links = 4;
  EXPECT_EQ(NetworkScene::Others(scene.Build(), 0), (Others{1, 2}));
}

TEST(CurveConsistencyTest, StrongLinksInEitherDirectionSuffice) {
  NetworkScene scene(2);
  scene.options.strong_link_views = 4;
  scene.Link(0, 1, 10, 40, 4);
  scene.Link(1, 0, 15, 45, 3);
  const CurveConsistency network = scene.Build();
  ASSERT_EQ(NetworkScene::Others(network, 0), Others{1});
  ASSERT_EQ(NetworkScene::Others(network, 1), Others{0});
  EXPECT_EQ(network.overlaps[0][0].partner, NetworkScene::PartnersOn(1, {{10, 40}}));
  EXPECT_EQ(network.overlaps[1][0].partner, NetworkScene::PartnersOn(0, {{15, 45}}));
}

TEST(CurveConsistencyTest, CurveWithoutLinksOfItsOwnOverlapsNothing) {
  NetworkScene scene(2);
  scene.Link(1, 0, 10, 40, 4);
  const CurveConsistency network = scene.Build();
  EXPECT_EQ(NetworkScene::Others(network, 0), Others());
  EXPECT_EQ(NetworkScene::Others(network, 1), Others{0});
  EXPECT_EQ(network.num_clusters, 1);
}

TEST(CurveConsistencyTest, GapsAreFilledAndSpecklesRemoved) {
  NetworkScene scene(2);
  scene.options.overlap_regularity_px = 5;
  scene.Link(0, 1, 10, 20, 4);
  scene.Link(0, 1, 24, 40, 4);  // 5 px from the run before
  scene.Link(0, 1, 50, 54, 4);  // 3 px long
  const CurveConsistency filled = scene.Build();
  ASSERT_EQ(NetworkScene::Others(filled, 0), Others{1});
  EXPECT_EQ(filled.overlaps[0][0].partner, NetworkScene::PartnersOn(1, {{10, 40}}));
  scene.options.overlap_regularity_px = 2.5;
  const CurveConsistency raw = scene.Build();
  ASSERT_EQ(NetworkScene::Others(raw, 0), Others{1});
  EXPECT_EQ(raw.overlaps[0][0].partner,
            NetworkScene::PartnersOn(1, {{10, 20}, {24, 40}, {50, 54}}));
}

TEST(CurveConsistencyTest, SpecklesMakeAClusterButNoOverlap) {
  NetworkScene scene(2);
  scene.options.overlap_regularity_px = 9;
  scene.Link(0, 1, 10, 16, 4);
  scene.Link(0, 1, 40, 46, 4);
  const CurveConsistency network = scene.Build();
  EXPECT_EQ(NetworkScene::Others(network, 0), Others());
  EXPECT_EQ(network.num_clusters, 1);
}

TEST(CurveConsistencyTest, OverlapsAscendByCurve) {
  NetworkScene scene(4);
  for (const int other : {3, 0, 1}) scene.Link(2, other, 10, 40, 4);
  EXPECT_EQ(NetworkScene::Others(scene.Build(), 2), (Others{0, 1, 3}));
}

TEST(CurveConsistencyTest, ClustersAreComponents) {
  NetworkScene scene(8);
  const auto link = [&](int a, int b) {
    scene.Link(a, b, 10, 40, 4);
    scene.Link(b, a, 10, 40, 4);
  };
  link(7, 4);
  link(4, 1);
  link(6, 7);
  link(5, 2);
  EXPECT_EQ(scene.Build().num_clusters, 4);  // 0, 3, {1, 4, 6, 7} and {2, 5}
}

TEST(CurveConsistencyTest, NothingOfNothing) {
  const CurveConsistency network = NetworkScene(0).Build();
  EXPECT_TRUE(network.overlaps.empty());
  EXPECT_EQ(network.num_clusters, 0);
}

TEST(CountAgreeingViewsTest, CountsDifferentPrimaryViewsItsOwnIncluded) {
  NetworkScene scene(5);
  // Curves 1 and 2 come from one view, curve 3 from curve 0's own.
  const ViewId anchors[] = {7, 2, 2, 7, 4};
  for (int c = 0; c < 5; ++c) scene.samples.origins[c].primary_view = anchors[c];
  scene.Link(0, 1, 0, 30, 4);
  scene.Link(0, 2, 20, 40, 4);
  scene.Link(0, 3, 0, 60, 4);
  scene.Link(0, 4, 10, 50, 4);
  scene.Link(4, 1, 45, 60, 4);
  std::vector<int> expected;
  for (int k = 0; k < 60; ++k) expected.push_back(1 + (k < 40) + (k >= 10 && k < 50));
  for (int k = 0; k < 3 * 60; ++k) expected.push_back(1);
  for (int k = 0; k < 60; ++k) expected.push_back(1 + (k >= 45));
  const CurveConsistency network = scene.Build();
  for (int s = 0; s < scene.samples.NumSamples(); ++s) {
    EXPECT_EQ(CountAgreeingViews(scene.samples, network, s), expected[s]) << s;
  }
}

}  // namespace
}  // namespace limn
