// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The kd-tree of spatial_index.cc, which alone includes this.

#include <vector>

#include <Eigen/Core>
#include <flann/algorithms/dist.h>
#include <flann/algorithms/kdtree_single_index.h>

namespace limn {

class KdTree {
 public:
  // Precondition: the points are not empty, and stay where they are.
  KdTree(std::vector<Eigen::Vector3d>* points, int leaf_size)
      : tree_(flann::Matrix<double>(points->front().data(), points->size(), 3),
              flann::KDTreeSingleIndexParams(leaf_size)) {
    tree_.buildIndex();
  }
  KdTree(const KdTree&) = delete;
  KdTree& operator=(const KdTree&) = delete;

  // A result has full(), worstDist(), below which points are looked for, and addPoint(squared
  // distance, index).
  template <typename Result>
  void Find(const Eigen::Vector3d& query, Result* result) const {
    FlannResult<Result> adapted(result);
    tree_.findNeighbors(adapted, query.data(), flann::SearchParams());
  }

 private:
  template <typename Result>
  class FlannResult : public flann::ResultSet<double> {
   public:
    explicit FlannResult(Result* result) : result_(result) {}
    bool full() const override { return result_->full(); }
    void addPoint(double squared_distance, size_t index) override {
      result_->addPoint(squared_distance, index);
    }
    double worstDist() const override { return result_->worstDist(); }

   private:
    Result* result_;
  };

  flann::KDTreeSingleIndex<flann::L2_Simple<double>> tree_;
};

}  // namespace limn
