// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/parabola.h"

#include <vector>

#include <gtest/gtest.h>

namespace limn {
namespace {

const std::vector<double> kArcs = {0, 1, 2.5, 4, 6};

std::vector<Eigen::Vector3d> PointsOf(const Parabola& parabola) {
  std::vector<Eigen::Vector3d> points;
  for (const double arc : kArcs) points.push_back(parabola.At(arc));
  return points;
}

const Parabola kBent = {{1000, -2000, 3000}, {1, 0, 0.5}, {0, 0.1, 0}};

TEST(FitParabolaTest, FindsTheParabolaThroughItsPoints) {
  const Parabola fit = FitParabola(PointsOf(kBent), kArcs);
  EXPECT_LT((fit.start - kBent.start).norm(), 1e-9);
  EXPECT_LT((fit.slope - kBent.slope).norm(), 1e-9);
  EXPECT_LT((fit.bend - kBent.bend).norm(), 1e-9);
  EXPECT_LT((fit.SlopeAt(10) - Eigen::Vector3d(1, 2, 0.5)).norm(), 1e-8);
}

TEST(FitParabolaTest, PriorDrawsItToALine) {
  const Parabola some = FitParabola(PointsOf(kBent), kArcs, 100);
  EXPECT_GT(some.bend.y(), 0.005);
  EXPECT_LT(some.bend.y(), 0.09);
  EXPECT_LT(FitParabola(PointsOf(kBent), kArcs, 1e9).bend.norm(), 1e-6);
}

TEST(FitParabolaTest, PriorMakesALineOfTwoPoints) {
  const std::vector<Eigen::Vector3d> points = {{0, 0, 0}, {2, 0, 0}};
  const Parabola fit = FitParabola(points, std::vector<double>{-2, 0}, 1);
  EXPECT_LT((fit.At(1) - Eigen::Vector3d(3, 0, 0)).norm(), 1e-9);
}

}  // namespace
}  // namespace limn
