// SPDX-License-Identifier: BSD-3-Clause
#include "limn/plans/level_nodes.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

std::vector<Eigen::Matrix3d> Within(double sigma, size_t count) {
  return std::vector<Eigen::Matrix3d>(count, sigma * sigma * Eigen::Matrix3d::Identity());
}

TEST(LevelNodes, AChainOfLevelLinesSharesItsHeight) {
  const std::vector<Eigen::Vector3d> places = {{0, 0, 0}, {2, 0.01, 0}, {5, -0.01, 0}};
  const auto level = LevelNodes(places, Within(0.01, 3), {{0, 1}, {1, 2}});
  for (const Eigen::Vector3d& place : level) EXPECT_NEAR(place.y(), 0, 1e-12);
  EXPECT_EQ(level[0].y(), level[1].y());
  EXPECT_EQ(level[1].y(), level[2].y());
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(level[i].x(), places[i].x());
}

TEST(LevelNodes, BetterKnownNodesMoveLess) {
  std::vector<Eigen::Matrix3d> covariances = Within(0.01, 2);
  covariances[0] *= 1e-2;
  const auto level = LevelNodes({{0, 0, 0}, {2, 0.011, 0}}, covariances, {{0, 1}});
  EXPECT_NEAR(level[0].y(), 0.011 / 101, 1e-9);
}

TEST(LevelNodes, WhatIsOffIndeedStays) {
  const std::vector<Eigen::Vector3d> places = {{0, 0, 0}, {2, 0.03, 0}, {0, 5, 0}, {1, 5.2, 0}};
  // More than two standard deviations; more than a degree.
  EXPECT_EQ(LevelNodes(places, Within(0.005, 4), {{0, 1}}), places);
  EXPECT_EQ(LevelNodes(places, Within(1, 4), {{2, 3}}), places);
  // Nothing is known of one end.
  std::vector<Eigen::Matrix3d> covariances = Within(0.1, 4);
  covariances[1].setZero();
  EXPECT_EQ(LevelNodes(places, covariances, {{0, 1}}), places);
}

// A gable seen along its ridge: both long sides are nearly plumb, the short one level.
TEST(LevelNodes, NoLineLosesItsLength) {
  const std::vector<Eigen::Vector3d> places = {{0, 2, 0}, {0.02, 2, 0}, {0.01, 0, 0}};
  const auto level = LevelNodes(places, Within(0.01, 3), {{0, 2}, {1, 2}, {0, 1}});
  EXPECT_GT((level[1] - level[0]).norm(), 0.01);
}

}  // namespace
}  // namespace limn
