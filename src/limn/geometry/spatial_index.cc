// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/spatial_index.h"

#include <algorithm>
#include <limits>
#include <utility>

#ifdef LIMN_WITH_FLANN
#include "limn/geometry/kd_tree_of_flann.h"
#else
#include "limn/geometry/kd_tree_of_nanoflann.h"
#endif
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr int kLeafSize = 16;
using Neighbor = SpatialIndex::Neighbor;

// The libraries' own result sets allocate per query and break ties by the order of the tree.
class NearestResult {
 public:
  bool full() const { return best_.index >= 0; }
  void addPoint(double squared_distance, size_t index) {
    const int candidate = static_cast<int>(index);
    if (squared_distance < best_.squared_distance ||
        (squared_distance == best_.squared_distance && candidate < best_.index)) {
      best_ = {candidate, squared_distance};
    }
  }
  // The trees keep what is strictly closer than this; one step up lets ties through.
  double worstDist() const {
    return std::nextafter(best_.squared_distance, std::numeric_limits<double>::infinity());
  }
  const Neighbor& best() const { return best_; }

 private:
  Neighbor best_{-1, std::numeric_limits<double>::infinity()};
};

bool IsNearer(const Neighbor& a, const Neighbor& b) {
  return std::pair(a.squared_distance, a.index) < std::pair(b.squared_distance, b.index);
}

class NearestOnesResult {
 public:
  NearestOnesResult(size_t count, std::vector<Neighbor>* heap) : count_(count), heap_(heap) {}
  bool full() const { return heap_->size() == count_; }
  void addPoint(double squared_distance, size_t index) {
    const Neighbor candidate{static_cast<int>(index), squared_distance};
    if (full()) {
      if (!IsNearer(candidate, heap_->front())) return;
      std::pop_heap(heap_->begin(), heap_->end(), IsNearer);
      heap_->pop_back();
    }
    heap_->push_back(candidate);
    std::push_heap(heap_->begin(), heap_->end(), IsNearer);
  }
  double worstDist() const {
    const double infinity = std::numeric_limits<double>::infinity();
    return full() ? std::nextafter(heap_->front().squared_distance, infinity) : infinity;
  }

 private:
  size_t count_;
  std::vector<Neighbor>* heap_;  // farthest in front
};

class WithinResult {
 public:
  WithinResult(double squared_radius, std::vector<Neighbor>* found)
      : squared_radius_(squared_radius), found_(found) {}
  bool full() const { return true; }
  void addPoint(double squared_distance, size_t index) {
    found_->push_back({static_cast<int>(index), squared_distance});
  }
  double worstDist() const { return squared_radius_; }

 private:
  double squared_radius_;
  std::vector<Neighbor>* found_;
};

}  // namespace

struct SpatialIndex::Tree {
  std::vector<Eigen::Vector3d> points;
  KdTree kd_tree;

  explicit Tree(const std::vector<Eigen::Vector3d>& input)
      : points(input), kd_tree(&points, kLeafSize) {}
};

SpatialIndex::SpatialIndex(const std::vector<Eigen::Vector3d>& points)
    : num_points_(points.size()) {
  for (const Eigen::Vector3d& point : points) {
    if (!point.allFinite()) throw InputError("spatial index: a point is not finite");
  }
  if (!points.empty()) tree_ = std::make_unique<Tree>(points);
}

SpatialIndex::~SpatialIndex() = default;
SpatialIndex::SpatialIndex(SpatialIndex&&) noexcept = default;
SpatialIndex& SpatialIndex::operator=(SpatialIndex&&) noexcept = default;

SpatialIndex::Neighbor SpatialIndex::Nearest(const Eigen::Vector3d& query) const {
  NearestResult result;
  tree_->kd_tree.Find(query, &result);
  return result.best();
}

void SpatialIndex::FindNearest(const Eigen::Vector3d& query, size_t count,
                               std::vector<Neighbor>* found) const {
  found->clear();
  if (!tree_ || count == 0) return;
  NearestOnesResult result(count, found);
  tree_->kd_tree.Find(query, &result);
  std::sort_heap(found->begin(), found->end(), IsNearer);
}

void SpatialIndex::FindWithin(const Eigen::Vector3d& query, double radius,
                              std::vector<Neighbor>* found) const {
  found->clear();
  if (!tree_) return;
  WithinResult result(radius * radius, found);
  tree_->kd_tree.Find(query, &result);
  std::sort(found->begin(), found->end(),
            [](const Neighbor& a, const Neighbor& b) { return a.index < b.index; });
}

}  // namespace limn
