// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numeric>
#include <utility>
#include <vector>

namespace limn {

// Disjoint sets of 0..n-1. The representative of a set is its smallest member, so that results do
// not depend on the order of the unions. Amortized near-constant time per call.
class UnionFind {
 public:
  explicit UnionFind(int count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  int Find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  // Returns whether the two were in different sets.
  bool Union(int i, int j) {
    i = Find(i);
    j = Find(j);
    if (i == j) return false;
    if (j < i) std::swap(i, j);
    parent_[j] = i;
    return true;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace limn
