// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/position_fit.h"

#include <random>

#include <gtest/gtest.h>

#include "limn/alignment/wire_room.h"
#include "limn/util/angles.h"
#include "support/random_numbers.h"

namespace limn {
namespace {

using testing::AngleDeg;
using testing::RandomSimilarity;

// Sources in a ball of this radius, targets with noise.
std::vector<PointPair> Pairs(const Similarity3d& target_from_source, int count, double radius,
                             double noise, unsigned seed) {
  std::mt19937 random(seed);
  testing::NormalDistribution<double> normal;
  testing::UniformDistribution<double> uniform(0, radius);
  std::vector<PointPair> pairs;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d direction = testing::RandomDirection(&random);
    const Eigen::Vector3d source = uniform(random) * direction;
    const Eigen::Vector3d error = testing::RandomVector(normal, random);
    pairs.push_back({source, target_from_source * source + noise * error});
  }
  return pairs;
}

TEST(PositionFit, RoundingIsNoError) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    Similarity3d far = RandomSimilarity(2, seed);
    far.translation = Eigen::Vector3d(450000, 5411000, 120);  // a grid of a survey
    const auto fit = FitPositions(Pairs(far, 20, 3, 0, seed));
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->num_rejected, 0u) << seed;
  }
}

TEST(PositionFit, FindsASimilarityAmongWrongPairs) {
  const Similarity3d truth = RandomSimilarity(2, 3);
  std::vector<PointPair> pairs = Pairs(truth, 20, 3, 0, 1);
  for (int i = 0; i < 9; ++i) pairs[2 * i].target += Eigen::Vector3d(30 + i, -20, 5 * i);
  const auto fit = FitPositions(pairs);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->target_from_source.scale, truth.scale, 1e-9);
  EXPECT_LT((fit->target_from_source.rotation - truth.rotation).norm(), 1e-9);
  EXPECT_LT((fit->target_from_source.translation - truth.translation).norm(), 1e-9);
  EXPECT_LT(fit->median_residual, 1e-9);
  EXPECT_GT(fit->residuals[0], 30);
}

// The reported errors are the true ones, up to this share, when this many of the pairs are wrong.
void ExpectErrorsAreTold(int count, int num_wrong, double noise, double tolerance) {
  double up2 = 0, told_up2 = 0, scale2 = 0, told_scale2 = 0;
  for (unsigned seed = 1; seed <= 400; ++seed) {
    const Similarity3d truth = RandomSimilarity(2, seed);
    std::vector<PointPair> pairs = Pairs(truth, count, 8, noise, seed);
    for (int i = 0; i < num_wrong; ++i) pairs[2 * i].target += Eigen::Vector3d(500 + i, -20, 5 * i);
    const auto fit = FitPositions(pairs);
    ASSERT_TRUE(fit);
    const Eigen::Matrix3d error = fit->target_from_source.rotation * truth.rotation.transpose();
    up2 += std::pow(AngleDeg(error.col(2), Eigen::Vector3d::UnitZ()) * kDeg, 2);
    told_up2 += std::pow(fit->up_error_rad, 2);
    scale2 += std::pow(fit->target_from_source.scale / truth.scale - 1, 2);
    told_scale2 += std::pow(fit->scale_error, 2);
  }
  EXPECT_NEAR(std::sqrt(told_up2 / up2), 1, tolerance) << count;
  EXPECT_NEAR(std::sqrt(told_scale2 / scale2), 1, tolerance) << count;
}

TEST(PositionFit, TellsItsErrors) { ExpectErrorsAreTold(40, 0, 1, 0.15); }

TEST(PositionFit, WrongPairsTellNothing) { ExpectErrorsAreTold(40, 18, 1, 0.15); }

TEST(PositionFit, TellsTheErrorsOfFewPairs) {
  for (const int count : {4, 5, 6, 8}) ExpectErrorsAreTold(count, 0, 0.1, 0.25);
  ExpectErrorsAreTold(8, 1, 0.1, 0.25);
  ExpectErrorsAreTold(10, 3, 0.1, 0.25);
}

TEST(PositionFit, FewPairsDoNotTellUpWithFalseConfidence) {
  for (const int count : {4, 5, 6, 7}) {
    int num_told = 0, num_false = 0;
    for (unsigned seed = 1; seed <= 400; ++seed) {
      const Similarity3d truth = RandomSimilarity(2, seed);
      const auto fit = FitPositions(Pairs(truth, count, 8, 0.3, seed));
      ASSERT_TRUE(fit);
      if (fit->up_error_rad > 2 * kDeg) continue;
      ++num_told;
      const Eigen::Matrix3d error = fit->target_from_source.rotation * truth.rotation.transpose();
      num_false += AngleDeg(error.col(2), Eigen::Vector3d::UnitZ()) > 6;
    }
    EXPECT_GT(num_told, 40) << count;
    EXPECT_LE(num_false, 2) << count;
  }
}

TEST(PositionFit, AWrongOneOfFewPairsIsRejected) {
  for (const int count : {5, 6, 7}) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
      std::vector<PointPair> pairs = Pairs({}, count, 8, 0.1, seed);
      const size_t wrong = seed % count;
      pairs[wrong].target += 30 * Eigen::Vector3d::UnitX();
      const auto fit = FitPositions(pairs);
      ASSERT_TRUE(fit);
      EXPECT_EQ(fit->num_rejected, 1u);
      EXPECT_GT(fit->scaled_residuals[wrong], 5 * fit->typical_scaled_residual);
    }
  }
}

TEST(PositionFit, SeveralWrongOnesOfFewPairsShowInTheErrors) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::vector<PointPair> pairs = Pairs({}, 6, 8, 0.1, seed);
    pairs[seed % 6].target += 30 * Eigen::Vector3d::UnitX();
    pairs[(seed + 2) % 6].target += 30 * Eigen::Vector3d::UnitY();
    const auto fit = FitPositions(pairs);
    ASSERT_TRUE(fit);
    EXPECT_GT(fit->up_error_rad, 10 * kDeg);
    EXPECT_GT(fit->scale_error, 0.2);
  }
}

TEST(PositionFit, PairsOnAHorizontalLineLeaveUpOpen) {
  std::vector<PointPair> pairs;
  for (int i = 0; i < 10; ++i) pairs.push_back({{1.0 * i, 0, 0}, {2.0 * i, 0, 0}});
  const auto fit = FitPositions(pairs);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->target_from_source.scale, 2, 1e-9);
  EXPECT_GT(fit->up_error_rad, 1);
  EXPECT_LT(fit->scale_error, 1e-6);
}

TEST(PositionFit, PairsOnAVerticalLineLeaveOnlyTheHeadingOpen) {
  std::vector<PointPair> pairs;
  for (int i = 0; i < 10; ++i) pairs.push_back({{1.0 * i, 0, 0}, {0, 0, 2.0 * i}});
  const auto fit = FitPositions(pairs);
  ASSERT_TRUE(fit);
  EXPECT_LT(fit->up_error_rad, 1e-6);
  EXPECT_GT(fit->heading_error_rad, 1);
}

TEST(PositionFit, AccuratePairsCountMore) {
  std::vector<PointPair> pairs = Pairs({}, 20, 3, 0, 1);
  for (int i = 0; i < 9; ++i) {
    pairs[i].target += Eigen::Vector3d(0.1, 0, 0);
    pairs[i].weight = 1e-6;
  }
  const auto fit = FitPositions(pairs);
  ASSERT_TRUE(fit);
  EXPECT_LT(fit->target_from_source.translation.norm(), 1e-4);
}

TEST(PositionFit, PairsAreWrongByTheirAccuracy) {
  std::vector<PointPair> pairs = Pairs({}, 20, 3, 0.01, 1);
  std::mt19937 random(2);
  for (int i = 0; i < 16; i += 2) {
    // Far for the others, but not for these.
    pairs[i].target += 0.5 * testing::RandomDirection(&random);
    pairs[i].weight = 1e-3;
  }
  pairs[1].target.x() += 0.2;  // the other way round
  const auto fit = FitPositions(pairs);
  ASSERT_TRUE(fit);
  const double limit = 5 * fit->typical_scaled_residual;
  EXPECT_GT(fit->scaled_residuals[1], limit);
  for (int i = 0; i < 16; i += 2) {
    EXPECT_GT(fit->residuals[i], fit->residuals[1]);
    EXPECT_LT(fit->scaled_residuals[i], limit);
  }
  EXPECT_LT(fit->target_from_source.translation.norm(), 0.01);
}

TEST(PositionFit, NeedsFourPairsAndTwoPlaces) {
  EXPECT_FALSE(FitPositions({}));
  EXPECT_FALSE(FitPositions(Pairs({}, 3, 3, 0, 1)));
  EXPECT_FALSE(FitPositions(std::vector<PointPair>(5)));
}

}  // namespace
}  // namespace limn
