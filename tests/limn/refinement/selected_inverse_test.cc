// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/selected_inverse.h"

#include <random>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace limn {
namespace {

// Blocks that hang together in a chain with some shortcuts.
Eigen::MatrixXd ChainMatrix(int num_blocks) {
  std::mt19937 random(3);
  testing::NormalDistribution<double> gauss(0, 1);
  const int size = 3 * num_blocks;
  Eigen::MatrixXd matrix = 0.1 * Eigen::MatrixXd::Identity(size, size);
  for (int b = 0; b < num_blocks; ++b) {
    for (const int other : {b + 1, b + 2, (7 * b) % num_blocks}) {
      if (other >= num_blocks) continue;
      Eigen::MatrixXd row = Eigen::MatrixXd::Zero(2, size);
      for (const int at : {b, other}) {
        for (int i = 0; i < 6; ++i) row(i / 3, 3 * at + i % 3) += gauss(random);
      }
      matrix += row.transpose() * row;
    }
  }
  return matrix;
}

TEST(SelectedInverse, BlocksAreThoseOfTheInverse) {
  constexpr int kNumBlocks = 40;
  const Eigen::MatrixXd matrix = ChainMatrix(kNumBlocks);
  const Eigen::MatrixXd inverse = matrix.inverse();
  const auto blocks = DiagonalBlocksOfInverse(matrix.sparseView());
  ASSERT_TRUE(blocks.has_value());
  ASSERT_EQ(blocks->size(), static_cast<size_t>(kNumBlocks));
  for (int b = 0; b < kNumBlocks; ++b) {
    const Eigen::Matrix3d expected = inverse.block<3, 3>(3 * b, 3 * b);
    EXPECT_LT(((*blocks)[b] - expected).norm(), 1e-9 * inverse.norm()) << "block " << b;
  }
}

TEST(SelectedInverse, NothingOfAnIndefiniteMatrix) {
  Eigen::MatrixXd matrix = ChainMatrix(4);
  matrix(5, 5) = -1;
  EXPECT_FALSE(DiagonalBlocksOfInverse(matrix.sparseView()).has_value());
}

}  // namespace
}  // namespace limn
