// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// kd_tree_of_flann.h for where FLANN is not installed; the distances are the same.

#include <vector>

#include <Eigen/Core>
#include <nanoflann.hpp>

namespace limn {

static_assert(NANOFLANN_VERSION >= 0x140, "older ones do not build the tree at once");

class KdTree {
 public:
  KdTree(std::vector<Eigen::Vector3d>* points, int leaf_size)
      : points_{points}, tree_(3, points_, nanoflann::KDTreeSingleIndexAdaptorParams(leaf_size)) {}
  KdTree(const KdTree&) = delete;
  KdTree& operator=(const KdTree&) = delete;

  template <typename Result>
  void Find(const Eigen::Vector3d& query, Result* result) const {
    NanoflannResult<Result> adapted{result};
    tree_.findNeighbors(adapted, query.data(), {});
  }

 private:
  // The names are nanoflann's.
  struct Points {
    const std::vector<Eigen::Vector3d>* points;
    size_t kdtree_get_point_count() const { return points->size(); }
    double kdtree_get_pt(size_t index, size_t axis) const { return (*points)[index][axis]; }
    template <typename Box>
    bool kdtree_get_bbox(Box& /*box*/) const {
      return false;
    }
  };
  template <typename Result>
  struct NanoflannResult {
    // For newer versions, as is sort().
    using DistanceType = double;
    using IndexType = size_t;

    Result* result;
    bool full() const { return result->full(); }
    bool addPoint(double squared_distance, size_t index) {
      result->addPoint(squared_distance, index);
      return true;  // go on
    }
    double worstDist() const { return result->worstDist(); }
    void sort() {}
  };

  Points points_;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>, Points, 3>
      tree_;
};

}  // namespace limn
