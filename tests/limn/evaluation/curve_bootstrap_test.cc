// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/curve_bootstrap.h"

#include <cmath>

#include <gtest/gtest.h>

namespace limn {
namespace {

// `num_right` of `count` curves of total 1 are right.
std::vector<CurveShare> Some(int num_right, int count) {
  std::vector<CurveShare> curves(count, {0, 1});
  for (int i = 0; i < num_right; ++i) curves[i].right = 1;
  return curves;
}

TEST(BootstrapShares, HaveTheSpreadOfTheBinomialDistribution) {
  const ShareIntervals intervals = BootstrapShares(Some(200, 400), Some(40, 400));
  // Standard errors: sqrt(p (1 - p) / 400); the bounds of 500 resamples are known to a fifth of
  // the half width.
  const double half = 1.96 * 0.025;
  EXPECT_NEAR(intervals.precision->low, 0.5 - half, half / 5);
  EXPECT_NEAR(intervals.precision->high, 0.5 + half, half / 5);
  const double small_half = 1.96 * 0.015;
  EXPECT_NEAR(intervals.recall->low, 0.1 - small_half, small_half / 5);
  EXPECT_NEAR(intervals.recall->high, 0.1 + small_half, small_half / 5);
  // F at P = 0.5, R = 0.1 is 1 / 6; its derivatives by P and R: 2 R^2 / (P + R)^2 = 1 / 18 and
  // 2 P^2 / (P + R)^2 = 25 / 18.
  const double f_half = 1.96 * std::hypot(0.025 / 18, 0.015 * 25 / 18);
  EXPECT_NEAR(intervals.f->low, 1.0 / 6 - f_half, f_half / 5);
  EXPECT_NEAR(intervals.f->high, 1.0 / 6 + f_half, f_half / 5);
}

TEST(BootstrapShares, CurvesWeighByTheirTotals) {
  // One curve of 99 that is right and 99 of 1 that are not: the long one decides.
  std::vector<CurveShare> curves = Some(0, 99);
  curves.push_back({99, 99});
  const ShareIntervals intervals = BootstrapShares(curves, {});
  EXPECT_EQ(intervals.precision->low, 0);     // without the long one, 37 % of the resamples
  EXPECT_GT(intervals.precision->high, 0.7);  // with three, at least 297 of 394
}

TEST(BootstrapShares, AreExactWhereThereIsNoDoubt) {
  const ShareIntervals intervals = BootstrapShares(Some(5, 5), Some(0, 7));
  EXPECT_EQ(intervals.precision->low, 1);
  EXPECT_EQ(intervals.precision->high, 1);
  EXPECT_EQ(intervals.recall->high, 0);
  EXPECT_EQ(intervals.f->high, 0);
}

TEST(BootstrapShares, NeedTwoCurves) {
  std::vector<CurveShare> one = Some(1, 1);
  one.push_back({0, 0});
  const ShareIntervals intervals = BootstrapShares(one, Some(1, 2));
  EXPECT_FALSE(intervals.precision.has_value());
  EXPECT_TRUE(intervals.recall.has_value());
  EXPECT_FALSE(intervals.f.has_value());
  EXPECT_FALSE(BootstrapShares({}, {}).f.has_value());
}

TEST(BootstrapShares, AreRepeatable) {
  const ShareIntervals a = BootstrapShares(Some(3, 10), Some(6, 10));
  const ShareIntervals b = BootstrapShares(Some(3, 10), Some(6, 10));
  EXPECT_EQ(a.f->low, b.f->low);
  EXPECT_EQ(a.f->high, b.f->high);
}

}  // namespace
}  // namespace limn
