// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/SparseCore>

namespace limn {

// The 3 x 3 diagonal blocks of the inverse of a sparse symmetric positive definite matrix whose
// size is a multiple of 3. The inverse is computed only where the Cholesky factor has entries
// (Takahashi, Fagan and Chen 1973). Empty if the matrix is not positive definite. Time and memory
// as for the factorization.
std::optional<std::vector<Eigen::Matrix3d>> DiagonalBlocksOfInverse(
    const Eigen::SparseMatrix<double>& matrix);

}  // namespace limn
