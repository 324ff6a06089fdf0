// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace limn {

// A symmetric positive definite system A x = b whose entries are zero farther than `half_width`
// from the diagonal. Add entries (of either triangle, each once), then solve in place. O(n
// half_width^2).
class BandedSystem {
 public:
  BandedSystem(int size, int half_width);

  void Add(int row, int col, double value);
  double& Right(int row) { return right_[row]; }

  // Returns false if the matrix is not positive definite; then `Right` is undefined. May be called
  // once.
  bool Solve();

 private:
  double& Entry(int row, int col) { return lower_[row * (half_width_ + 1) + (row - col)]; }

  int size_;
  int half_width_;
  std::vector<double> lower_;  // row-major: (row, row - k) at row * (half_width + 1) + k
  std::vector<double> right_;
};

}  // namespace limn
