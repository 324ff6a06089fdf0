// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/triangle_index.h"

#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace limn {
namespace {

using CornersOfTriangle = std::array<Eigen::Vector3d, 3>;

class RandomTriangles : public ::testing::Test {
 protected:
  Eigen::Vector3d Point(double extent) {
    testing::UniformDistribution<double> uniform(-extent, extent);
    return {uniform(random_), uniform(random_), uniform(random_)};
  }

  void Fill(int count) {
    for (int t = 0; t < count; ++t) {
      const Eigen::Vector3d at = Point(1);
      for (int k = 0; k < 3; ++k) vertices_.push_back(at + Point(0.1));
      triangles_.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
  }

  CornersOfTriangle Corners(int t) const {
    return {vertices_[3 * t], vertices_[3 * t + 1], vertices_[3 * t + 2]};
  }

  std::mt19937 random_{1};
  std::vector<Eigen::Vector3d> vertices_;
  std::vector<std::array<int, 3>> triangles_;
};

TEST_F(RandomTriangles, DistanceIsThatOfTheNearestOfManyPlaces) {
  constexpr int kSteps = 200;
  for (int round = 0; round < 50; ++round) {
    const CornersOfTriangle corners = {Point(1), Point(1), Point(1)};
    const Eigen::Vector3d query = Point(1.5);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kSteps; ++i) {
      for (int k = 0; i + k <= kSteps; ++k) {
        const Eigen::Vector3d place =
            (i * corners[0] + k * corners[1] + (kSteps - i - k) * corners[2]) / kSteps;
        least = std::min(least, (place - query).norm());
      }
    }
    const double distance = DistanceToTriangle(query, corners);
    EXPECT_LE(distance, least + 1e-12);
    EXPECT_GE(distance, least - 4.0 / kSteps);
  }
}

TEST(DistanceToTriangle, AboveBesideAndBeyondACorner) {
  const CornersOfTriangle corners = {Eigen::Vector3d(0, 0, 0), {2, 0, 0}, {0, 2, 0}};
  EXPECT_DOUBLE_EQ(DistanceToTriangle({0.5, 0.5, -3}, corners), 3);
  EXPECT_DOUBLE_EQ(DistanceToTriangle({1, -4, 3}, corners), 5);
  EXPECT_DOUBLE_EQ(DistanceToTriangle({5, 0, 4}, corners), 5);
  EXPECT_DOUBLE_EQ(DistanceToTriangle({1, 1, 0}, corners), 0);
}

TEST(DistanceToTriangle, OfASegmentAndAPoint) {
  const Eigen::Vector3d a(0, 0, 0), b(1, 0, 0), c(3, 0, 0);
  EXPECT_DOUBLE_EQ(DistanceToTriangle({2, 2, 0}, {a, b, c}), 2);
  EXPECT_DOUBLE_EQ(DistanceToTriangle({0, 3, 4}, {a, a, a}), 5);
}

TEST_F(RandomTriangles, NearestAgreesWithTryingEveryTriangle) {
  Fill(1000);
  const TriangleIndex index(vertices_, triangles_);
  const auto is_odd = [](int triangle) { return triangle % 2 == 1; };
  int num_found = 0;
  for (int round = 0; round < 200; ++round) {
    const Eigen::Vector3d query = Point(1.2);
    int best = 1;
    for (int t = 1; t < 1000; t += 2) {
      if (DistanceToTriangle(query, Corners(t)) < DistanceToTriangle(query, Corners(best))) {
        best = t;
      }
    }
    const double least = DistanceToTriangle(query, Corners(best));
    const auto nearest = index.Nearest(query, 0.15, is_odd);
    EXPECT_EQ(nearest.has_value(), least <= 0.15);
    if (!nearest) continue;
    ++num_found;
    EXPECT_EQ(nearest->triangle, best);
    EXPECT_EQ(nearest->distance, least);
  }
  EXPECT_GT(num_found, 50);
  EXPECT_LT(num_found, 190);
}

TEST(TriangleIndex, WithoutTrianglesThereIsNone) {
  const TriangleIndex index({}, {});
  EXPECT_FALSE(index.Nearest({0, 0, 0}, 1e9, [](int) { return true; }));
}

}  // namespace
}  // namespace limn
