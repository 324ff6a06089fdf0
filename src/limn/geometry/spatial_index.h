// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

namespace limn {

// Exact nearest-neighbor look-up in a fixed set of 3D points: a single kd-tree of FLANN or
// nanoflann, leaves of 16 points. Building takes O(n log n), a look-up O(log n + found). Immutable,
// hence safe to share between threads.
class SpatialIndex {
 public:
  struct Neighbor {
    int index = -1;
    double squared_distance = 0;
  };

  // Throws InputError if a coordinate is not finite.
  explicit SpatialIndex(const std::vector<Eigen::Vector3d>& points);
  ~SpatialIndex();
  SpatialIndex(SpatialIndex&&) noexcept;
  SpatialIndex& operator=(SpatialIndex&&) noexcept;

  size_t size() const { return num_points_; }

  // The nearest point; the smallest index wins on ties. Precondition: size() > 0.
  Neighbor Nearest(const Eigen::Vector3d& query) const;

  // The `count` nearest points, or all if there are fewer, nearest first, on ties the smaller
  // index; `found` is cleared first.
  void FindNearest(const Eigen::Vector3d& query, size_t count, std::vector<Neighbor>* found) const;

  // All points closer than `radius`, ascending by index; `found` is cleared first.
  void FindWithin(const Eigen::Vector3d& query, double radius, std::vector<Neighbor>* found) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
  size_t num_points_ = 0;
};

}  // namespace limn
