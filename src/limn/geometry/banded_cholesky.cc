// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/banded_cholesky.h"

#include <algorithm>
#include <cmath>

namespace limn {

BandedSystem::BandedSystem(int size, int half_width)
    : size_(size),
      half_width_(half_width),
      lower_(static_cast<size_t>(size) * (half_width + 1), 0.0),
      right_(size, 0.0) {}

void BandedSystem::Add(int row, int col, double value) {
  Entry(std::max(row, col), std::min(row, col)) += value;
}

bool BandedSystem::Solve() {
  for (int i = 0; i < size_; ++i) {
    const int first = std::max(0, i - half_width_);
    for (int j = first; j <= i; ++j) {
      double sum = Entry(i, j);
      for (int k = std::max(first, j - half_width_); k < j; ++k) sum -= Entry(i, k) * Entry(j, k);
      if (i == j) {
        if (!(sum > 0)) return false;
        Entry(i, i) = std::sqrt(sum);
      } else {
        Entry(i, j) = sum / Entry(j, j);
      }
    }
    for (int k = first; k < i; ++k) right_[i] -= Entry(i, k) * right_[k];
    right_[i] /= Entry(i, i);
  }
  for (int i = size_ - 1; i >= 0; --i) {
    const int last = std::min(size_ - 1, i + half_width_);
    for (int k = i + 1; k <= last; ++k) right_[i] -= Entry(k, i) * right_[k];
    right_[i] /= Entry(i, i);
  }
  return true;
}

}  // namespace limn
