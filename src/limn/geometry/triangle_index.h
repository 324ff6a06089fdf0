// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace limn {

// Distance from a point to a triangle, which may be degenerate. Constant time.
double DistanceToTriangle(const Eigen::Vector3d& query,
                          const std::array<Eigen::Vector3d, 3>& corners);

// Exact look-up of the nearest of fixed triangles: an R-tree of their boxes (Boost.Geometry).
// Building takes O(n log n). Immutable, hence safe to share between threads.
class TriangleIndex {
 public:
  struct Neighbor {
    int triangle = -1;
    double distance = 0;
  };

  // Precondition: indices in range, coordinates finite.
  TriangleIndex(const std::vector<Eigen::Vector3d>& vertices,
                const std::vector<std::array<int, 3>>& triangles);
  ~TriangleIndex();
  TriangleIndex(TriangleIndex&&) noexcept;
  TriangleIndex& operator=(TriangleIndex&&) noexcept;

  // The nearest of the triangles within `max_distance` that `accepts` takes, on ties the first;
  // nothing if there is none. O(log n + triangles whose boxes are about as near).
  std::optional<Neighbor> Nearest(const Eigen::Vector3d& query, double max_distance,
                                  const std::function<bool(int triangle)>& accepts) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace limn
