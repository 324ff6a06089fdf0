#include "limn/refinement/selected_inverse.h"

#include <Eigen/SparseCholesky>

namespace limn {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Index = Sparse::StorageIndex;

// Entries of the inverse of L D L' where the unit lower triangle L has entries, column by column
// from the last: Z(:, j) follows from the entries of Z at the rows of column j, which later columns
// hold.
class SelectedInverse {
 public:
  SelectedInverse(Sparse lower, const Eigen::VectorXd& diagonal)
      : lower_(std::move(lower)), inverse_(lower_), diagonal_(1 / diagonal.array()) {
    scatter_.assign(static_cast<size_t>(lower_.cols()), -1);
    for (Index j = static_cast<Index>(lower_.cols()) - 1; j >= 0; --j) SolveColumn(j);
  }

  // Zero where L has no entry.
  double At(Index row, Index col) const {
    if (row == col) return diagonal_[row];
    return inverse_.coeff(std::max(row, col), std::min(row, col));
  }

 private:
  // `lower_` is strictly lower.
  void SolveColumn(Index j) {
    const Index begin = lower_.outerIndexPtr()[j];
    const Index end = lower_.outerIndexPtr()[j + 1];
    const Index* rows = lower_.innerIndexPtr();
    const double* factor = lower_.valuePtr();
    std::vector<double> sum(static_cast<size_t>(end - begin), 0);
    for (Index i = begin; i < end; ++i) scatter_[rows[i]] = i - begin;
    for (Index i = begin; i < end; ++i) {
      const Index col = rows[i];
      sum[i - begin] += factor[i] * diagonal_[col];
      for (Index k = lower_.outerIndexPtr()[col]; k < lower_.outerIndexPtr()[col + 1]; ++k) {
        const Index place = scatter_[rows[k]];
        if (place < 0) continue;
        sum[place] += factor[i] * inverse_.valuePtr()[k];
        sum[i - begin] += factor[begin + place] * inverse_.valuePtr()[k];
      }
    }
    for (Index i = begin; i < end; ++i) {
      inverse_.valuePtr()[i] = -sum[i - begin];
      diagonal_[j] += factor[i] * sum[i - begin];
      scatter_[rows[i]] = -1;
    }
  }

  Sparse lower_;
  Sparse inverse_;
  Eigen::VectorXd diagonal_;
  std::vector<Index> scatter_;  // per row its place in the column at work, or -1
};

}  // namespace

std::optional<std::vector<Eigen::Matrix3d>> DiagonalBlocksOfInverse(const Sparse& matrix) {
  const Eigen::SimplicialLDLT<Sparse> factor(matrix);
  if (factor.info() != Eigen::Success || !(factor.vectorD().array() > 0).all()) return std::nullopt;
  const Sparse lower = factor.matrixL().nestedExpression().triangularView<Eigen::StrictlyLower>();
  const SelectedInverse inverse(lower, factor.vectorD());
  const auto& permuted = factor.permutationP().indices();
  std::vector<Eigen::Matrix3d> blocks(static_cast<size_t>(matrix.cols() / 3));
  for (size_t b = 0; b < blocks.size(); ++b) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        blocks[b](r, c) = inverse.At(permuted[3 * b + r], permuted[3 * b + c]);
      }
    }
  }
  return blocks;
}

}  // namespace limn
