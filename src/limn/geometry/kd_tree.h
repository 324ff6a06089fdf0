// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// For spatial_index.cc only: FLANN's kd-tree, or nanoflann's where FLANN is not installed. Both
// find the same points at the same distances.

#include <vector>

#include <Eigen/Core>

#ifdef LIMN_WITH_FLANN
#include <flann/algorithms/dist.h>
#include <flann/algorithms/kdtree_single_index.h>
#else
#include <nanoflann.hpp>
#endif

namespace limn {

inline constexpr int kKdTreeLeafSize = 16;

// A result set has full(), worstDist(), below which points are looked for, and addPoint(squared
// distance, index).

#ifdef LIMN_WITH_FLANN

class KdTree {
 public:
  // Precondition: the points are not empty and stay where they are.
  explicit KdTree(std::vector<Eigen::Vector3d>* points)
      : tree_(flann::Matrix<double>(points->front().data(), points->size(), 3),
              flann::KDTreeSingleIndexParams(kKdTreeLeafSize)) {
    tree_.buildIndex();
  }

  template <typename Result>
  void Find(const Eigen::Vector3d& query, Result* result) const {
    Virtual<Result> of_flann(result);
    tree_.findNeighbors(of_flann, query.data(), flann::SearchParams());
  }

 private:
  template <typename Result>
  class Virtual : public flann::ResultSet<double> {
   public:
    explicit Virtual(Result* result) : result_(result) {}
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

#else

class KdTree {
 public:
  explicit KdTree(std::vector<Eigen::Vector3d>* points)
      : points_{points},
        tree_(3, points_, nanoflann::KDTreeSingleIndexAdaptorParams(kKdTreeLeafSize)) {}
  KdTree(const KdTree&) = delete;
  KdTree& operator=(const KdTree&) = delete;

  template <typename Result>
  void Find(const Eigen::Vector3d& query, Result* result) const {
    Going<Result> going{result};
    tree_.findNeighbors(going, query.data(), {});
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
  struct Going {
    Result* result;
    bool full() const { return result->full(); }
    bool addPoint(double squared_distance, size_t index) {
      result->addPoint(squared_distance, index);
      return true;  // go on
    }
    double worstDist() const { return result->worstDist(); }
    void sort() {}  // since 1.6
  };

  Points points_;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>, Points, 3>
      tree_;
};

#endif

}  // namespace limn
