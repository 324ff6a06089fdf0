// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/selected_inverse.h"

#include <algorithm>

#include <Eigen/SparseCholesky>

namespace limn {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Index = Sparse::StorageIndex;

// Entries of the inverse of L D L' where the unit lower triangle L has entries, column by column
// from the last: Z(:, j) follows from the entries of Z at the rows of column j, which later columns
// hold. The entry on the diagonal is the first of a column.
Sparse InverseWithin(const Sparse& lower, const Eigen::VectorXd& diagonal) {
  const Index* start = lower.outerIndexPtr();
  const Index* rows = lower.innerIndexPtr();
  const double* factor = lower.valuePtr();
  Sparse inverse = lower;
  double* value = inverse.valuePtr();
  std::vector<double> sum;
  std::vector<Index> place(static_cast<size_t>(lower.cols()), -1);  // of a row in `sum`, or -1
  for (Index j = static_cast<Index>(lower.cols()) - 1; j >= 0; --j) {
    const Index begin = start[j] + 1;
    const Index end = start[j + 1];
    sum.assign(static_cast<size_t>(end - begin), 0);
    for (Index i = begin; i < end; ++i) place[rows[i]] = i - begin;
    for (Index i = begin; i < end; ++i) {
      const Index col = rows[i];
      sum[i - begin] += factor[i] * value[start[col]];
      for (Index k = start[col] + 1; k < start[col + 1]; ++k) {
        const Index other = place[rows[k]];
        if (other < 0) continue;
        sum[other] += factor[i] * value[k];
        sum[i - begin] += factor[begin + other] * value[k];
      }
    }
    value[start[j]] = 1 / diagonal[j];
    for (Index i = begin; i < end; ++i) {
      value[i] = -sum[i - begin];
      value[start[j]] += factor[i] * sum[i - begin];
      place[rows[i]] = -1;
    }
  }
  return inverse;
}

}  // namespace

std::optional<std::vector<Eigen::Matrix3d>> DiagonalBlocksOfInverse(const Sparse& matrix) {
  const Eigen::SimplicialLDLT<Sparse> factor(matrix);
  if (factor.info() != Eigen::Success || !(factor.vectorD().array() > 0).all()) return std::nullopt;
  const Sparse lower = factor.matrixL().nestedExpression().triangularView<Eigen::UnitLower>();
  const Sparse inverse = InverseWithin(lower, factor.vectorD());
  const auto& permuted = factor.permutationP().indices();
  std::vector<Eigen::Matrix3d> blocks(static_cast<size_t>(matrix.cols() / 3));
  for (size_t b = 0; b < blocks.size(); ++b) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        const Index row = permuted[3 * b + r];
        const Index col = permuted[3 * b + c];
        blocks[b](r, c) = inverse.coeff(std::max(row, col), std::min(row, col));
      }
    }
  }
  return blocks;
}

}  // namespace limn
