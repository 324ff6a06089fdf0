// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/polyline.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace limn {
namespace {

const Polyline3d kCorner = {{0, 0, 0}, {3, 0, 0}, {3, 4, 0}};

TEST(Polyline, CumulativeLength) {
  EXPECT_EQ(CumulativeLength(kCorner), (std::vector<double>{0, 3, 7}));
  EXPECT_EQ(Length(kCorner), 7);
  EXPECT_TRUE(CumulativeLength({}).empty());
  EXPECT_EQ(Length({}), 0);
}

TEST(Polyline, ClosestPointInsideAtVerticesAndBeyondTheEnds) {
  const PolylinePoint inside = ClosestPoint(kCorner, {2, -1, 0});
  EXPECT_EQ(inside.segment, 0);
  EXPECT_NEAR(inside.t, 2.0 / 3, 1e-12);
  EXPECT_NEAR(inside.squared_distance, 1, 1e-12);
  const PolylinePoint corner = ClosestPoint(kCorner, {4, -1, 0});
  EXPECT_EQ(corner.position, kCorner[1]);
  EXPECT_EQ(corner.segment, 0);  // the first on ties
  const PolylinePoint beyond = ClosestPoint(kCorner, {3, 9, 2});
  EXPECT_EQ(beyond.position, kCorner[2]);
  EXPECT_EQ(beyond.t, 1);
  EXPECT_NEAR(beyond.squared_distance, 29, 1e-12);
}

TEST(Polyline, ClosestPointSurvivesRepeatedVertices) {
  const PolylinePoint place =
      ClosestPoint(Polyline3d{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}, {0.5, 1, 0});
  EXPECT_EQ(place.segment, 1);
  EXPECT_NEAR(place.t, 0.5, 1e-12);
}

TEST(Polyline, ClosestPointIsNoFartherThanAnySample) {
  std::mt19937 random(3);
  testing::NormalDistribution<double> normal;
  Polyline3d polyline(12);
  for (Eigen::Vector3d& point : polyline) point = {normal(random), normal(random), normal(random)};
  const Polyline3d samples = ResampleUniform(polyline, 0.01);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d query = testing::RandomVector(normal, random);
    double best = INFINITY;
    for (const Eigen::Vector3d& sample : samples) best = std::min(best, (sample - query).norm());
    const PolylinePoint place = ClosestPoint(polyline, query);
    const double distance = std::sqrt(place.squared_distance);
    EXPECT_NEAR((place.position - query).norm(), distance, 1e-12);
    EXPECT_LE(distance, best + 1e-12);
    EXPECT_GE(distance, best - 0.01);
  }
}

TEST(Polyline, CutKeepsVerticesInBetweenAndWholeEnds) {
  const Polyline3d polyline = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {1, 2, 0}, {0.1, 2, 0}};
  EXPECT_EQ(CutPolyline(polyline, 0, Length(polyline)), polyline);
  const Polyline3d part = CutPolyline(polyline, 0.25, 2);
  ASSERT_EQ(part.size(), 3u);
  EXPECT_TRUE(part[0].isApprox(Eigen::Vector3d(0.25, 0, 0)));
  EXPECT_EQ(part[1], polyline[1]);
  EXPECT_TRUE(part[2].isApprox(Eigen::Vector3d(1, 1, 0)));
  // A cut at a vertex does not repeat it.
  EXPECT_EQ(CutPolyline(polyline, 0, 1), (Polyline3d{polyline[0], polyline[1]}));
  EXPECT_EQ(CutPolyline(polyline, 1, 3), (Polyline3d{polyline[1], polyline[2]}));
}

TEST(Polyline, ResampleUniformKeepsEndsAndStep) {
  const Polyline3d samples = ResampleUniform(kCorner, 1.5);
  ASSERT_EQ(samples.size(), 6u);  // five steps of 1.4
  EXPECT_EQ(samples.front(), kCorner.front());
  EXPECT_EQ(samples.back(), kCorner.back());
  EXPECT_LT((samples[2] - Eigen::Vector3d(2.8, 0, 0)).norm(), 1e-12);
  EXPECT_LT((samples[3] - Eigen::Vector3d(3, 1.2, 0)).norm(), 1e-12);
}

TEST(Polyline, SimplifiedIsWithinADistanceOfTheVertices) {
  Polyline3d helix;
  for (int i = 0; i <= 400; ++i) {
    const double turn = 0.01 * M_PI * i;
    helix.emplace_back(std::cos(turn), std::sin(turn), 0.1 * turn);
  }
  const Polyline3d simplified = Simplified(helix, 0.02);
  EXPECT_EQ(simplified.front(), helix.front());
  EXPECT_EQ(simplified.back(), helix.back());
  EXPECT_LT(simplified.size(), 64u);
  double most = 0;
  for (const Eigen::Vector3d& point : helix) {
    most = std::max(most, ClosestPoint(simplified, point).squared_distance);
  }
  EXPECT_LE(most, 0.02 * 0.02);
  EXPECT_GT(most, 0.005 * 0.005);
  EXPECT_EQ(Simplified(helix, 1e-6), helix);
}

TEST(Polyline, SimplifiedKeepsWhatALoopIsMadeOf) {
  const Polyline3d square = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 0}};
  EXPECT_EQ(Simplified(square, 0.1),
            (Polyline3d{square[0], square[2], square[3], square[4], square[5]}));
  EXPECT_TRUE(Simplified({}, 1).empty());
  EXPECT_EQ(Simplified(Polyline3d{{1, 2, 3}}, 1).size(), 1u);
  EXPECT_EQ(Simplified(Polyline3d{{0, 0, 0}, {0, 0, 0}}, 1).size(), 2u);
}

TEST(Polyline, ResampleUniformOfDegeneratePolylines) {
  EXPECT_TRUE(ResampleUniform({}, 1).empty());
  EXPECT_EQ(ResampleUniform(Polyline3d{{1, 2, 3}, {1, 2, 3}}, 1).size(), 1u);
  EXPECT_EQ(ResampleUniform(Polyline3d{{0, 0, 0}, {1, 0, 0}}, 10).size(), 2u);
}

}  // namespace
}  // namespace limn
