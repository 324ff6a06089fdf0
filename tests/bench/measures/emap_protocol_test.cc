// SPDX-License-Identifier: BSD-3-Clause
#include "bench/measures/emap_protocol.h"

#include <gtest/gtest.h>

#include "limn/evaluation/plain_curves.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using testing::Curves;

Polyline3d LineAlongX(double x0, double x1, double y) { return {{x0, y, 0.5}, {x1, y, 0.5}}; }

TEST(EmapProtocol, PerfectCurvesScoreOne) {
  const CurveSet truth = Curves({LineAlongX(0, 1, 0.25), LineAlongX(0, 1, 0.75)});
  const auto scores = EvaluateByEmap(truth, truth);
  ASSERT_TRUE(scores);
  EXPECT_EQ(scores->num_points, 400);
  EXPECT_LT(scores->accuracy, 0.0005);
  EXPECT_LT(scores->completeness, 0.0025);
  ASSERT_EQ(scores->rows.size(), 3u);
  for (const EmapScores::Row& row : scores->rows) {
    EXPECT_NEAR(row.precision, 1, 1e-9);
    EXPECT_NEAR(row.recall, 1, 1e-9);
    EXPECT_NEAR(row.f, 1, 1e-9);
  }
}

TEST(EmapProtocol, OffsetShowsInAccuracyAndThresholds) {
  const auto scores = EvaluateByEmap(Curves({LineAlongX(0, 1, 0.257)}),
                                     Curves({LineAlongX(0, 1, 0.25), LineAlongX(0, 1, 0.75)}));
  ASSERT_TRUE(scores);
  EXPECT_NEAR(scores->accuracy, 0.007, 1e-4);
  EXPECT_NEAR(scores->completeness, (0.007 + 0.493) / 2, 1e-3);
  EXPECT_DOUBLE_EQ(scores->rows[0].precision, 0);
  EXPECT_DOUBLE_EQ(scores->rows[0].f, 0);
  EXPECT_NEAR(scores->rows[1].precision, 1, 1e-9);
  EXPECT_NEAR(scores->rows[1].recall, 0.5, 1e-9);
  EXPECT_NEAR(scores->rows[1].f, 2.0 / 3, 1e-9);
}

TEST(EmapProtocol, CurvesShorterThanTheSpacingVanish) {
  const CurveSet truth = Curves({LineAlongX(0, 1, 0.25)});
  EXPECT_FALSE(EvaluateByEmap(Curves({LineAlongX(0, 0.0049, 0.25)}), truth));
  EXPECT_FALSE(EvaluateByEmap({}, truth));
  EXPECT_EQ(EvaluateByEmap(Curves({LineAlongX(0, 0.0051, 0.25)}), truth)->num_points, 1);
  EXPECT_EQ(EvaluateByEmap(Curves({LineAlongX(0, 0.0101, 0.25)}), truth)->num_points, 2);
}

TEST(EmapProtocol, VoxelsAverageWhatSharesACell) {
  const double cell = 2.0 / 256;
  const std::vector<Eigen::Vector3d> points = {
      {0.1 * cell, 0, 0}, {0.5 * cell, 0, 0}, {-0.1 * cell, 0, 0}, {1.5 * cell, 0, 0}};
  const auto means = AverageVoxels(points, 256);
  ASSERT_EQ(means.size(), 3u);
  EXPECT_DOUBLE_EQ(means[0].x(), -0.1 * cell);
  EXPECT_DOUBLE_EQ(means[1].x(), 0.3 * cell);
  EXPECT_DOUBLE_EQ(means[2].x(), 1.5 * cell);
}

TEST(EmapProtocol, VoxelsMergeCopies) {
  const CurveSet truth = Curves({LineAlongX(0, 1, 0.25)});
  EmapOptions options;
  options.average_voxels = true;
  const auto one = EvaluateByEmap(truth, truth, options);
  const auto two =
      EvaluateByEmap(Curves({LineAlongX(0, 1, 0.25), LineAlongX(0, 1, 0.25)}), truth, options);
  EXPECT_EQ(one->num_points, two->num_points);
  EXPECT_NEAR(one->num_points, 128, 1);
}

TEST(EmapProtocol, RefusesAnEmptyTruth) {
  EXPECT_THROW(EvaluateByEmap({}, {}), InputError);
  EXPECT_THROW(EvaluateByEmap({}, Curves({LineAlongX(0, 1, 0)}), {.spacing = 0}), OptionError);
}

}  // namespace
}  // namespace limn
