// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/assignment.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/util/errors.h"
#include "support/random_numbers.h"

namespace limn {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using AssignmentPoints = std::vector<Eigen::Vector3d>;

AssignmentPoints PointsAlongX(const std::vector<double>& places) {
  AssignmentPoints points;
  for (const double x : places) points.emplace_back(x, 0, 0);
  return points;
}

AssignmentPoints RandomPoints(int count, std::mt19937* random) {
  testing::UniformDistribution<double> coordinate(0, 1);
  AssignmentPoints points;
  for (int i = 0; i < count; ++i) {
    points.push_back(testing::RandomVector(coordinate, *random));
  }
  return points;
}

double CostOf(const AssignmentPoints& points, const AssignmentPoints& targets,
              const std::vector<int>& target_of) {
  double cost = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    if (target_of[i] >= 0) cost += (points[i] - targets[target_of[i]]).norm();
  }
  return cost;
}

// Of all assignments of a few points to no fewer targets.
double LeastCost(const AssignmentPoints& points, const AssignmentPoints& targets) {
  std::vector<int> order(targets.size());
  std::iota(order.begin(), order.end(), 0);
  double least = std::numeric_limits<double>::infinity();
  do {
    least = std::min(least, CostOf(points, targets, order));
  } while (std::next_permutation(order.begin(), order.end()));
  return least;
}

TEST(AssignPoints, GivesAwayTheNearestForASmallerSum) {
  EXPECT_THAT(AssignPoints(PointsAlongX({0, 1}), PointsAlongX({0.9})), ElementsAre(-1, 0));
  // 1 is 0.1 from 0.9, but then 0 would have to go to 2: 2.1 in all instead of 1.9. To tell sums
  // apart 2 is off the line.
  AssignmentPoints targets = PointsAlongX({0.9, 2});
  targets[1].y() = 0.5;
  EXPECT_THAT(AssignPoints(PointsAlongX({0, 1}), targets), ElementsAre(0, 1));
}

TEST(AssignPoints, HasTheSmallestSumOfAll) {
  std::mt19937 random(7);
  for (int round = 0; round < 60; ++round) {
    const AssignmentPoints few = RandomPoints(1 + round % 5, &random);
    const AssignmentPoints many = RandomPoints(6, &random);
    const std::vector<int> to_many = AssignPoints(few, many), to_few = AssignPoints(many, few);
    EXPECT_NEAR(CostOf(few, many, to_many), LeastCost(few, many), 1e-12);
    EXPECT_NEAR(CostOf(many, few, to_few), LeastCost(few, many), 1e-12);
    EXPECT_EQ(std::set<int>(to_many.begin(), to_many.end()).size(), few.size());
    EXPECT_EQ(std::ranges::count(to_few, -1), 6 - static_cast<int>(few.size()));
  }
}

TEST(AssignPoints, DoesNotDependOnTheOrderOrOnWhichAreTargets) {
  std::mt19937 random(8);
  AssignmentPoints points = RandomPoints(40, &random), targets = RandomPoints(40, &random);
  // Many equally good assignments.
  for (AssignmentPoints* set : {&points, &targets}) {
    for (Eigen::Vector3d& point : *set) point = (3 * point).array().round();
  }
  const auto pairs_of = [](const AssignmentPoints& from, const AssignmentPoints& to, bool swap) {
    std::multiset<std::vector<double>> pairs;
    const std::vector<int> target_of = AssignPoints(from, to);
    for (size_t i = 0; i < from.size(); ++i) {
      const Eigen::Vector3d& a = swap ? to[target_of[i]] : from[i];
      const Eigen::Vector3d& b = swap ? from[i] : to[target_of[i]];
      pairs.insert({a.x(), a.y(), a.z(), b.x(), b.y(), b.z()});
    }
    return pairs;
  };
  const auto pairs = pairs_of(points, targets, false);
  EXPECT_EQ(pairs_of(targets, points, true), pairs);
  std::ranges::shuffle(points, random);
  std::ranges::shuffle(targets, random);
  EXPECT_EQ(pairs_of(points, targets, false), pairs);
}

TEST(AssignPoints, OfNothing) {
  EXPECT_THAT(AssignPoints({}, PointsAlongX({1})), IsEmpty());
  EXPECT_THAT(AssignPoints(PointsAlongX({1, 2}), {}), ElementsAre(-1, -1));
}

TEST(AssignPoints, CanBeCancelled) {
  const std::atomic<bool> cancelled = true;
  RunContext context;
  context.cancelled = &cancelled;
  EXPECT_THROW(AssignPoints(PointsAlongX({1}), PointsAlongX({1}), context), Cancelled);
}

// Their distances are not finite: any assignment, but one.
TEST(AssignPoints, EndsForPlacesThatAreTooFarAway) {
  EXPECT_THAT(AssignPoints(PointsAlongX({1e200}), PointsAlongX({0})), ElementsAre(0));
  EXPECT_EQ(AssignPoints(PointsAlongX({1e200, 0}), PointsAlongX({0, -1e200})).size(), 2u);
}

}  // namespace
}  // namespace limn
