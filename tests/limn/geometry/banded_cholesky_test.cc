// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/banded_cholesky.h"

#include <random>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace limn {
namespace {

class BandedSystemTest : public ::testing::TestWithParam<std::pair<int, int>> {};

TEST_P(BandedSystemTest, AgreesWithDenseCholesky) {
  const auto [size, half_width] = GetParam();
  std::mt19937 random(11);
  testing::UniformDistribution<double> uniform(-1, 1);
  BandedSystem banded(size, half_width);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd right(size);
  for (int row = 0; row < size; ++row) {
    for (int col = std::max(0, row - half_width); col <= row; ++col) {
      const double value = row == col ? 2.0 * half_width + 1.5 : uniform(random);
      // Either triangle will do.
      if ((row + col) % 2) {
        banded.Add(row, col, value);
      } else {
        banded.Add(col, row, value);
      }
      dense(row, col) = dense(col, row) = value;
    }
    right[row] = uniform(random);
    banded.Right(row) = right[row];
  }
  const Eigen::VectorXd expected = dense.llt().solve(right);
  ASSERT_TRUE(banded.Solve());
  for (int row = 0; row < size; ++row) EXPECT_NEAR(banded.Right(row), expected[row], 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Sizes, BandedSystemTest,
                         ::testing::Values(std::pair(1, 0), std::pair(5, 0), std::pair(4, 8),
                                           std::pair(50, 1), std::pair(60, 8)));

TEST(BandedSystemEdgeTest, AddAccumulates) {
  BandedSystem system(1, 0);
  system.Add(0, 0, 1.5);
  system.Add(0, 0, 2.5);
  system.Right(0) = 8;
  ASSERT_TRUE(system.Solve());
  EXPECT_DOUBLE_EQ(system.Right(0), 2);
}

TEST(BandedSystemEdgeTest, RefusesIndefiniteMatrix) {
  BandedSystem system(2, 1);
  system.Add(0, 0, 1);
  system.Add(1, 0, 2);
  system.Add(1, 1, 1);
  EXPECT_FALSE(system.Solve());
}

}  // namespace
}  // namespace limn
