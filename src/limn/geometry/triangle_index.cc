// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/triangle_index.h"

#include <cmath>
#include <utility>

#include <Eigen/Geometry>
#include <boost/geometry.hpp>  // rtree.hpp of Boost 1.83 needs more than it includes
#include <boost/geometry/index/rtree.hpp>

#include "limn/geometry/polyline.h"

namespace limn {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::point<double, 3, bg::cs::cartesian>;
using BoostBox = bg::model::box<BoostPoint>;
using BoxedTriangle = std::pair<BoostBox, int>;

// The search begins in a ball of max_distance over this, which doubles until something is found.
constexpr double kFirstBall = 16;
constexpr size_t kLeafSize = 16;

BoostPoint ToBoost(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

}  // namespace

double DistanceToTriangle(const Eigen::Vector3d& query,
                          const std::array<Eigen::Vector3d, 3>& corners) {
  const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  bool is_above = normal.squaredNorm() > 0;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d& from = corners[k];
    const Eigen::Vector3d& to = corners[(k + 1) % 3];
    is_above = is_above && normal.cross(to - from).dot(query - from) >= 0;
  }
  if (is_above) return std::abs(normal.normalized().dot(query - corners[0]));
  const std::array border = {corners[0], corners[1], corners[2], corners[0]};
  return std::sqrt(ClosestPoint(border, query).squared_distance);
}

struct TriangleIndex::Tree {
  std::vector<std::array<Eigen::Vector3d, 3>> corners;
  bg::index::rtree<BoxedTriangle, bg::index::quadratic<kLeafSize>> boxes;
};

TriangleIndex::TriangleIndex(const std::vector<Eigen::Vector3d>& vertices,
                             const std::vector<std::array<int, 3>>& triangles)
    : tree_(std::make_unique<Tree>()) {
  std::vector<BoxedTriangle> boxes;
  for (const auto& [a, b, c] : triangles) {
    tree_->corners.push_back({vertices[a], vertices[b], vertices[c]});
    boxes.emplace_back(BoostBox(ToBoost(vertices[a].cwiseMin(vertices[b]).cwiseMin(vertices[c])),
                                ToBoost(vertices[a].cwiseMax(vertices[b]).cwiseMax(vertices[c]))),
                       static_cast<int>(boxes.size()));
  }
  tree_->boxes = decltype(tree_->boxes)(boxes);
}

TriangleIndex::~TriangleIndex() = default;
TriangleIndex::TriangleIndex(TriangleIndex&&) noexcept = default;
TriangleIndex& TriangleIndex::operator=(TriangleIndex&&) noexcept = default;

std::optional<TriangleIndex::Neighbor> TriangleIndex::Nearest(
    const Eigen::Vector3d& query, double max_distance,
    const std::function<bool(int triangle)>& accepts) const {
  const auto nearest_within = [&](double radius) {
    std::optional<Neighbor> nearest;
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(radius);
    const BoostBox around(ToBoost(query - reach), ToBoost(query + reach));
    for (auto it = tree_->boxes.qbegin(bg::index::intersects(around)); it != tree_->boxes.qend();
         ++it) {
      const int triangle = it->second;
      const double distance = DistanceToTriangle(query, tree_->corners[triangle]);
      const bool is_nearer = !nearest || std::pair(distance, triangle) <
                                             std::pair(nearest->distance, nearest->triangle);
      if (distance <= radius && is_nearer && accepts(triangle)) {
        nearest = Neighbor{triangle, distance};
      }
    }
    return nearest;
  };
  for (double radius = max_distance / kFirstBall; radius < max_distance; radius *= 2) {
    if (const auto nearest = nearest_within(radius)) return nearest;
  }
  return nearest_within(max_distance);
}

}  // namespace limn
