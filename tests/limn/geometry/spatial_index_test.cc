// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/spatial_index.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "limn/util/errors.h"
#include "support/random_numbers.h"

namespace limn {
namespace {

std::vector<Eigen::Vector3d> RandomPoints(int count, unsigned seed) {
  std::mt19937 random(seed);
  testing::UniformDistribution<double> uniform(-1, 1);
  std::vector<Eigen::Vector3d> points(count);
  for (Eigen::Vector3d& point : points) point = {uniform(random), uniform(random), uniform(random)};
  return points;
}

TEST(SpatialIndex, AgreesWithTryingEveryPoint) {
  const std::vector<Eigen::Vector3d> points = RandomPoints(2000, 1);
  const SpatialIndex index(points);
  std::vector<SpatialIndex::Neighbor> found;
  for (const Eigen::Vector3d& query : RandomPoints(200, 2)) {
    int best = 0;
    std::vector<int> within;
    for (int i = 0; i < 2000; ++i) {
      const double squared = (points[i] - query).squaredNorm();
      if (squared < (points[best] - query).squaredNorm()) best = i;
      if (squared < 0.04) within.push_back(i);
    }
    EXPECT_EQ(index.Nearest(query).index, best);
    EXPECT_NEAR(index.Nearest(query).squared_distance, (points[best] - query).squaredNorm(), 1e-12);
    index.FindWithin(query, 0.2, &found);
    ASSERT_EQ(found.size(), within.size());
    for (size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].index, within[i]);
  }
}

TEST(SpatialIndex, NearestOnesAreThoseOfSorting) {
  std::vector<Eigen::Vector3d> points = RandomPoints(500, 3);
  points.insert(points.end(), 40, points.front());  // ties
  const SpatialIndex index(points);
  std::vector<SpatialIndex::Neighbor> found;
  for (const Eigen::Vector3d& query : {points.front(), Eigen::Vector3d(0.3, 2, 0)}) {
    std::vector<std::pair<double, int>> sorted;
    for (size_t i = 0; i < points.size(); ++i) {
      sorted.push_back({(points[i] - query).squaredNorm(), static_cast<int>(i)});
    }
    std::sort(sorted.begin(), sorted.end());
    for (const size_t count : {size_t{1}, size_t{20}, size_t{60}, size_t{1000}}) {
      index.FindNearest(query, count, &found);
      ASSERT_EQ(found.size(), std::min(count, points.size()));
      for (size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].index, sorted[i].second);
    }
  }
  index.FindNearest({0, 0, 0}, 0, &found);
  EXPECT_TRUE(found.empty());
}

TEST(SpatialIndex, SmallestIndexWinsOnTies) {
  std::vector<Eigen::Vector3d> points(500, Eigen::Vector3d(1, 1, 1));
  for (int i = 0; i < 100; ++i) points.push_back({-1, -1, -1});
  const SpatialIndex index(points);
  EXPECT_EQ(index.Nearest({0.9, 1, 1}).index, 0);
  EXPECT_EQ(index.Nearest({1, 1, 1}).index, 0);
  EXPECT_EQ(index.Nearest({-1, -1, -1}).index, 500);
  EXPECT_EQ(index.Nearest({0, 0, 0}).index, 0);
}

TEST(SpatialIndex, EmptyOneFindsNothingAndBadPointsAreRefused) {
  const SpatialIndex index({});
  std::vector<SpatialIndex::Neighbor> found = {{1, 1}};
  index.FindWithin({0, 0, 0}, 10, &found);
  EXPECT_TRUE(found.empty());
  EXPECT_EQ(index.size(), 0u);
  EXPECT_THROW(SpatialIndex({{0, NAN, 0}}), InputError);
}

}  // namespace
}  // namespace limn
