// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/hss.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/util/errors.h"

namespace limn {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// Measured shares are that near.
constexpr double kIouError = 2e-4;

// A square of 10 m with a post of 4 m on each corner.
Wireframe Pavilion() {
  Wireframe wireframe;
  for (const double z : {0, 4}) {
    wireframe.vertices.insert(wireframe.vertices.end(),
                              {{0, 0, z}, {10, 0, z}, {10, 10, z}, {0, 10, z}});
  }
  for (const int i : {0, 1, 2, 3}) {
    wireframe.edges.emplace_back(i, i + 4);
    wireframe.edges.emplace_back(i + 4, (i + 1) % 4 + 4);
  }
  return wireframe;
}

Wireframe MovedBy(Wireframe wireframe, const Eigen::Vector3d& shift) {
  for (Eigen::Vector3d& vertex : wireframe.vertices) vertex += shift;
  return wireframe;
}

// An edge along x, 4 m long.
Wireframe OneEdge(double y = 0) { return {{{0, y, 0}, {4, y, 0}}, {{0, 1}}}; }

TEST(Hss, OfTheTruthIsOne) {
  for (const EdgeShape shape : {EdgeShape::kCylinder, EdgeShape::kHoho2025}) {
    HssOptions options;
    options.edge_shape = shape;
    const HssScores scores = ScoreHss(Pavilion(), Pavilion(), options);
    EXPECT_EQ(scores.corner_f1, 1);
    EXPECT_EQ(scores.edge_iou, 1);
    EXPECT_EQ(scores.hss, 1);
    EXPECT_EQ(scores.num_right_corners, 8);
    EXPECT_EQ(scores.num_edges, 8);
  }
}

// Of an edge 0.3 m beside the true one the corners are right, and the cylinders have lenses of
// 2 r^2 acos(d / 2r) - d/2 sqrt(4 r^2 - d^2) = 0.4900 of pi r^2 = 0.7854 in common.
TEST(Hss, OfAShiftedEdge) {
  const HssScores scores = ScoreHss(OneEdge(0.3), OneEdge());
  EXPECT_EQ(scores.corner_f1, 1);
  EXPECT_NEAR(scores.edge_iou, 0.4533, kIouError);
  EXPECT_NEAR(scores.hss, 2 * 0.4533 / 1.4533, kIouError);
  // Just at the distance corners are right, beyond it they are not.
  EXPECT_EQ(ScoreHss(OneEdge(0.5), OneEdge()).corner_f1, 1);
  const HssScores beyond = ScoreHss(OneEdge(0.501), OneEdge());
  EXPECT_EQ(beyond.corner_f1, 0);
  EXPECT_GT(beyond.edge_iou, 0.2);
  EXPECT_EQ(beyond.hss, 0);
}

TEST(Hss, OfAPartOfTheTruth) {
  Wireframe posts = Pavilion();
  std::erase_if(posts.edges, [](const auto& edge) { return edge.first >= 4; });
  posts.vertices.push_back({50, 50, 50});  // of no edge, and wrong
  posts.vertices.push_back({0, 0, 0});     // a copy
  const HssScores scores = ScoreHss(posts, Pavilion());
  EXPECT_EQ(scores.num_corners, 10);
  EXPECT_EQ(scores.corner_precision, 0.8);
  EXPECT_EQ(scores.corner_recall, 1);
  EXPECT_NEAR(scores.corner_f1, 16.0 / 18, 1e-12);
  EXPECT_EQ(scores.num_edges, 4);
  EXPECT_NEAR(scores.edges.first, 4 * 4 * M_PI / 4, 2e-3);
  EXPECT_NEAR(scores.edges.common, scores.edges.first, 1e-9);
  EXPECT_NEAR(scores.edge_iou, scores.edges.first / scores.edges.second, 1e-9);
  EXPECT_NEAR(scores.hss,
              2 * scores.corner_f1 * scores.edge_iou / (scores.corner_f1 + scores.edge_iou), 1e-12);
}

// The sum of all distances decides, as in the program of the challenge: the near pair is given up.
TEST(Hss, CornersAreAssignedForTheSmallestSum) {
  const Wireframe drawn{{{0, 0, 0}, {1, 0, 0}}, {}}, truth{{{0.9, 0, 0}, {2, 0.5, 0}}, {}};
  EXPECT_EQ(ScoreHss(drawn, truth).num_right_corners, 0);
  EXPECT_EQ(ScoreHss({{{1, 0, 0}}, {}}, truth).num_right_corners, 1);
}

TEST(Hss, IsSymmetricAndDoesNotDependOnOrder) {
  Wireframe drawn = MovedBy(Pavilion(), {0.2, -0.1, 0.3});
  drawn.edges.pop_back();
  const HssScores scores = ScoreHss(drawn, Pavilion());
  EXPECT_GT(scores.hss, 0.3);
  EXPECT_LT(scores.hss, 0.9);
  EXPECT_EQ(ScoreHss(Pavilion(), drawn).hss, scores.hss);
  Wireframe other;
  const int count = static_cast<int>(drawn.vertices.size());
  other.vertices.assign(drawn.vertices.rbegin(), drawn.vertices.rend());
  for (const auto& [a, b] : drawn.edges) other.edges.emplace_back(count - 1 - b, count - 1 - a);
  std::ranges::rotate(other.edges, other.edges.begin() + 3);
  EXPECT_EQ(ScoreHss(other, Pavilion()).hss, scores.hss);
  // Copies of edges, and edges of no length, change nothing.
  other.edges.push_back(other.edges.front());
  other.edges.emplace_back(2, 2);
  EXPECT_EQ(ScoreHss(other, Pavilion()).hss, scores.hss);
}

TEST(Hss, OfNothingIsZero) {
  const Wireframe nothing, corners{{{0, 0, 0}, {10, 0, 0}}, {}};
  for (const auto& [drawn, truth] : {std::pair(nothing, Pavilion()),
                                     {Pavilion(), nothing},
                                     {nothing, nothing},
                                     {nothing, corners}}) {
    const HssScores scores = ScoreHss(drawn, truth);
    EXPECT_EQ(scores.corner_f1, 0);
    EXPECT_EQ(scores.edge_iou, 0);
    EXPECT_EQ(scores.hss, 0);
  }
  // Corners without edges are found, but not edges.
  const HssScores scores = ScoreHss(corners, Pavilion());
  EXPECT_EQ(scores.num_right_corners, 2);
  EXPECT_EQ(scores.corner_f1, 0.4);
  EXPECT_EQ(scores.hss, 0);
}

TEST(Hss, OnlyWhatIsInTheRegionCounts) {
  HssOptions options;
  options.region = Eigen::AlignedBox3d(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(4, 4, 5));
  // The post at the origin: the middles of the edges at its top are outside.
  const HssScores scores = ScoreHss(Pavilion(), Pavilion(), options);
  EXPECT_EQ(scores.num_corners, 2);
  EXPECT_EQ(scores.num_true_corners, 2);
  EXPECT_EQ(scores.num_edges, 1);
  EXPECT_EQ(scores.num_true_edges, 1);
  EXPECT_NEAR(scores.edges.second, M_PI, 1e-3);
}

TEST(Hss, RadiusAndDistanceAreOptions) {
  HssOptions options;
  options.corner_distance = 0.2;
  EXPECT_EQ(ScoreHss(OneEdge(0.3), OneEdge(), options).corner_f1, 0);
  options.edge_radius = 0.1;
  EXPECT_EQ(ScoreHss(OneEdge(0.3), OneEdge(), options).edge_iou, 0);
  options.edge_radius = 3;
  EXPECT_GT(ScoreHss(OneEdge(0.3), OneEdge(), options).edge_iou, 0.85);
  options.edge_radius = 0;
  EXPECT_THAT([&] { ScoreHss(OneEdge(), OneEdge(), options); },
              ThrowsMessage<OptionError>(HasSubstr("edge_radius = 0")));
}

TEST(Hss, RefusesWireframesThatAreNone) {
  EXPECT_THAT(
      [] {
        ScoreHss({{{0, 0, 0}}, {{0, 1}}}, OneEdge());
      },
      ThrowsMessage<InputError>(HasSubstr("from corner 0 to 1 of 1")));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { ScoreHss(OneEdge(), OneEdge(nan)); },
              ThrowsMessage<InputError>(
                  HasSubstr("true wireframe: a coordinate of a corner is not finite")));
}

}  // namespace
}  // namespace limn
