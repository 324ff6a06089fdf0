// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Geometry>

namespace limn {

// Look-up of fixed rectangles: an R-tree (Boost.Geometry). Building takes O(n log n). Immutable,
// hence safe to share between threads.
class BoxIndex2d {
 public:
  // Empty boxes are never found. Precondition: the others are finite.
  explicit BoxIndex2d(const std::vector<Eigen::AlignedBox2d>& boxes);
  ~BoxIndex2d();
  BoxIndex2d(BoxIndex2d&&) noexcept;
  BoxIndex2d& operator=(BoxIndex2d&&) noexcept;

  // Indices of the boxes that have a point in common with `box`, which is not empty, ascending.
  // O(log n + found).
  std::vector<int> Meeting(const Eigen::AlignedBox2d& box) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace limn
