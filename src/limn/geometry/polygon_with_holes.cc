// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/polygon_with_holes.h"

#include <algorithm>
#include <numeric>

#include "limn/geometry/polygon_triangulation.h"

namespace limn {
namespace {

using Ring = std::vector<int>;  // corners in order

// Joins holes to a border.
class HoleJoiner {
 public:
  explicit HoleJoiner(const Polygon2d& polygon) {
    for (const Polyline2d& outline : polygon.outlines) {
      Ring ring(outline.size());
      std::iota(ring.begin(), ring.end(), static_cast<int>(corners_.size()));
      corners_.insert(corners_.end(), outline.begin(), outline.end());
      rings_.push_back(std::move(ring));
    }
  }

  const std::vector<Eigen::Vector2d>& corners() const { return corners_; }

  // One ring that runs along all outlines, and along cuts there and back.
  Ring Join() {
    // The hole that reaches farthest to the right has no other hole to its right.
    std::sort(rings_.begin() + 1, rings_.end(),
              [&](const Ring& a, const Ring& b) { return MaxX(a) > MaxX(b); });
    Ring ring = rings_[0];
    for (size_t h = 1; h < rings_.size(); ++h) ring = Joined(ring, h);
    return ring;
  }

 private:
  double MaxX(const Ring& ring) const { return corners_[RightMost(ring)].x(); }
  int RightMost(const Ring& ring) const {
    return *std::ranges::max_element(ring, {}, [&](int corner) { return corners_[corner].x(); });
  }

  // Through the nearest corner from which the hole is seen, or the nearest of all if there is none.
  Ring Joined(const Ring& ring, size_t hole) const {
    const Ring& inner = rings_[hole];
    const auto start = std::ranges::find(inner, RightMost(inner));
    const Eigen::Vector2d& from = corners_[*start];
    std::vector<int> places(ring.size());
    std::iota(places.begin(), places.end(), 0);
    std::ranges::stable_sort(
        places, {}, [&](int place) { return (corners_[ring[place]] - from).squaredNorm(); });
    const auto seen =
        std::ranges::find_if(places, [&](int place) { return Sees(ring, place, *start, hole); });
    const int place = seen != places.end() ? *seen : places.front();
    Ring joined(ring.begin(), ring.begin() + place + 1);
    joined.insert(joined.end(), start, inner.end());
    joined.insert(joined.end(), inner.begin(), start + 1);
    joined.insert(joined.end(), ring.begin() + place, ring.end());
    return joined;
  }

  bool Sees(const Ring& ring, int place, int corner, size_t hole) const {
    if (!IsInsideCorner(ring, place, corners_[corner])) return false;
    if (IsCrossed(ring, ring[place], corner)) return false;
    for (size_t h = hole; h < rings_.size(); ++h) {
      if (IsCrossed(rings_[h], ring[place], corner)) return false;
    }
    return true;
  }

  // Whether a point is in the angle of a corner, on its inner side.
  bool IsInsideCorner(const Ring& ring, int place, const Eigen::Vector2d& point) const {
    const int size = static_cast<int>(ring.size());
    const Eigen::Vector2d& before = corners_[ring[(place + size - 1) % size]];
    const Eigen::Vector2d& at = corners_[ring[place]];
    const Eigen::Vector2d& after = corners_[ring[(place + 1) % size]];
    const bool left_of_in = Cross(before, at, point) > 0;
    const bool left_of_out = Cross(at, after, point) > 0;
    return Cross(before, at, after) > 0 ? left_of_in && left_of_out : left_of_in || left_of_out;
  }

  bool IsCrossed(const Ring& ring, int from, int to) const {
    const Eigen::Vector2d &a = corners_[from], &b = corners_[to];
    for (size_t i = 0; i < ring.size(); ++i) {
      const int first = ring[i], second = ring[(i + 1) % ring.size()];
      if (first == from || first == to || second == from || second == to) continue;
      const Eigen::Vector2d &c = corners_[first], &d = corners_[second];
      if (Cross(a, b, c) * Cross(a, b, d) <= 0 && Cross(c, d, a) * Cross(c, d, b) <= 0) return true;
    }
    return false;
  }

  std::vector<Eigen::Vector2d> corners_;
  std::vector<Ring> rings_;
};

}  // namespace

std::vector<std::array<int, 3>> Triangulate(const Polygon2d& polygon) {
  if (polygon.outlines.empty()) return {};
  HoleJoiner joiner(polygon);
  const Ring ring = joiner.Join();
  std::vector<Eigen::Vector3d> corners;
  for (const int corner : ring) {
    corners.emplace_back(joiner.corners()[corner].x(), joiner.corners()[corner].y(), 0);
  }
  std::vector<std::array<int, 3>> triangles = TriangulatePolygon(corners);
  for (auto& triangle : triangles) {
    for (int& corner : triangle) corner = ring[corner];
  }
  return triangles;
}

}  // namespace limn
