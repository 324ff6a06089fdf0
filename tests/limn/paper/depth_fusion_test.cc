// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/depth_fusion.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

// `count` vertices 2 px apart.
FragmentRays StraightFragment(int count) {
  FragmentRays fragment;
  for (int i = 0; i < count; ++i) {
    fragment.positions_px.push_back({2.0 * i, 0});
    fragment.tangents_px.push_back({1, 0});
    fragment.rays.push_back({0.002 * i, 0, 1});
    fragment.normals.push_back({0, 1, 0});
    fragment.arc_px.push_back(2.0 * i);
  }
  return fragment;
}

DepthCandidate Candidate(double inverse_depth, double support, int second_rank) {
  DepthCandidate candidate;
  candidate.inverse_depth = inverse_depth;
  candidate.px_per_inverse_depth = 1000;
  candidate.weight = 0.1;
  candidate.weighted_support = support;
  candidate.second_rank = second_rank;
  return candidate;
}

TEST(DepthFusionTest, ModeWithMostSupportWins) {
  const int count = 20;
  std::vector<std::vector<DepthCandidate>> candidates(count);
  for (auto& of_vertex : candidates) {
    of_vertex = {Candidate(0.35, 4, 0), Candidate(0.2, 9, 1), Candidate(0.1, 5, 2)};
  }
  const auto fused = FuseDepths(StraightFragment(count), candidates, SketchOptions());
  ASSERT_EQ(fused.size(), candidates.size());
  for (const FusedDepth& depth : fused) {
    ASSERT_TRUE(depth.has_depth);
    EXPECT_NEAR(depth.inverse_depth, 0.2, 1e-9);
  }
}

TEST(DepthFusionTest, CandidatesOfAModeAreAveragedByInformation) {
  DepthCandidate strong = Candidate(0.2000, 8, 0), weak = Candidate(0.2001, 8, 1);  // 0.1 px apart
  strong.weight = 0.3;
  const auto fused =
      FuseDepths(StraightFragment(10), std::vector<std::vector<DepthCandidate>>(10, {strong, weak}),
                 SketchOptions());
  for (const FusedDepth& depth : fused) {
    EXPECT_NEAR(depth.inverse_depth, (0.3 * 0.2000 + 0.1 * 0.2001) / 0.4, 1e-9);
    EXPECT_NEAR(depth.weight, 0.4, 1e-9);
  }
}

TEST(DepthFusionTest, OutliersOfAModeAreDropped) {
  // Seven within 0.06 px, one 1.3 px off: inside the gate of the mode, but an outlier.
  std::vector<DepthCandidate> of_vertex;
  for (int i = 0; i < 7; ++i) of_vertex.push_back(Candidate(0.2 + 1e-5 * (i - 3), 8, i));
  of_vertex[3].weighted_support = 9;
  of_vertex.push_back(Candidate(0.2013, 8, 7));
  const auto fused =
      FuseDepths(StraightFragment(10), std::vector<std::vector<DepthCandidate>>(10, of_vertex),
                 SketchOptions());
  for (const FusedDepth& depth : fused) {
    EXPECT_NEAR(depth.inverse_depth, 0.2, 1e-9);
  }
}

TEST(DepthFusionTest, ThePaperTakesTheMeanWithinTwoSigmas) {
  // Depths of 5 +- .01 at every vertex, once 6.
  SketchOptions options;
  options.averaging = DepthAveraging::kPaper;
  std::vector<std::vector<DepthCandidate>> candidates(20);
  for (auto& of_vertex : candidates) {
    for (int i = 0; i < 13; ++i) {
      of_vertex.push_back(Candidate(1 / (i < 6 ? 4.99 : i < 12 ? 5.01 : 5.0), 8 + i, i));
    }
  }
  candidates[7].push_back(Candidate(1 / 6.0, 20, 13));
  const auto fused = FuseDepths(StraightFragment(20), candidates, options);
  for (const FusedDepth& depth : fused) {
    ASSERT_TRUE(depth.has_depth);
    EXPECT_NEAR(1 / depth.inverse_depth, 5, 1e-9);
    EXPECT_NEAR(depth.weight, 13 * 0.1, 1e-9);
  }
}

TEST(DepthFusionTest, ThePaperAveragesWhatIsNearAndKeepsASingleOne) {
  SketchOptions options;
  options.averaging = DepthAveraging::kPaper;
  const auto fused = FuseDepths(
      StraightFragment(3),
      {{Candidate(1 / 4.0, 8, 0), Candidate(1 / 5.0, 4, 1)}, {}, {Candidate(0.3, 4, 0)}}, options);
  EXPECT_NEAR(1 / fused[0].inverse_depth, 4.5, 1e-9);  // not weighted
  EXPECT_FALSE(fused[1].has_depth);
  EXPECT_EQ(fused[2].inverse_depth, 0.3);
}

TEST(DepthFusionTest, NoCandidatesNoDepth) {
  std::vector<std::vector<DepthCandidate>> candidates(20, {Candidate(0.2, 8, 0)});
  candidates[7].clear();
  const auto fused = FuseDepths(StraightFragment(20), candidates, SketchOptions());
  for (int i = 0; i < 20; ++i) EXPECT_EQ(fused[i].has_depth, i != 7);
}

TEST(DepthFusionTest, CertainIfAnyCandidateOfTheModeIs) {
  DepthCandidate certain = Candidate(0.2, 8, 0), uncertain = Candidate(0.2, 7, 1);
  uncertain.certain = false;
  std::vector<std::vector<DepthCandidate>> candidates(10, {certain, uncertain});
  candidates[5] = {uncertain};
  const auto fused = FuseDepths(StraightFragment(10), candidates, SketchOptions());
  for (int i = 0; i < 10; ++i) EXPECT_EQ(fused[i].certain, i != 5);
}

}  // namespace
}  // namespace limn
