// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/polygon_triangulation.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include <Eigen/Geometry>

#include "limn/geometry/polygon2d.h"

namespace limn {
namespace {

using Triangle = std::array<int, 3>;

// The corners in a plane in which the polygon goes counter-clockwise.
std::vector<Eigen::Vector2d> Flatten(std::span<const Eigen::Vector3d> corners) {
  const Eigen::Vector3d normal = PolygonAreaVector(corners);
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  int u = (axis + 1) % 3;
  int v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  std::vector<Eigen::Vector2d> flat;
  flat.reserve(corners.size());
  for (const Eigen::Vector3d& corner : corners) flat.emplace_back(corner[u], corner[v]);
  return flat;
}

// Clips ears off the corners that are left, a ring.
class EarClipper {
 public:
  explicit EarClipper(std::vector<Eigen::Vector2d> corners)
      : corners_(std::move(corners)),
        before_(corners_.size()),
        next_(corners_.size()),
        is_known_(corners_.size()) {
    std::iota(before_.begin(), before_.end(), -1);
    before_.front() = static_cast<int>(corners_.size()) - 1;
    std::iota(next_.begin(), next_.end(), 1);
    next_.back() = 0;
  }

  std::vector<Triangle> Run() {
    int at = 0;
    int misses = 0;
    for (int left = static_cast<int>(corners_.size()); left > 3;) {
      if (misses < left && !TestEar(at)) {
        ++misses;
        at = next_[at];
        continue;
      }
      if (misses == left && num_rounds_++ < kMaxRounds) {
        std::fill(is_known_.begin(), is_known_.end(), 0);
        misses = 0;
        continue;
      }
      // Even if no corner is an ear: the polygon is not simple.
      Clip(at);
      --left;
      misses = 0;
      // The next ear begins beyond this one, so that triangles do not become a fan of slivers.
      at = next_[next_[at]];
    }
    const int first = FirstLeft();
    Add({first, next_[first], before_[first]});
    return std::move(triangles_);
  }

 private:
  // An ear that is clipped changes what its neighbors are. Others it changes only where the
  // polygon touches itself: then all are looked at again, but only so often.
  static constexpr int kMaxRounds = 3;

  // A corner that was none is only looked at again when it is not known any more.
  bool TestEar(int at) {
    if (is_known_[at]) return false;
    is_known_[at] = 1;
    return IsEar(at);
  }

  // The corner itself still tells its next one.
  void Clip(int at) {
    Add(EarAt(at));
    const int before = before_[at];
    const int next = next_[at];
    next_[before] = next;
    before_[next] = before;
    is_clipped_[at] = 1;
    is_known_[before] = is_known_[next] = 0;
  }

  int FirstLeft() const {
    return static_cast<int>(std::find(is_clipped_.begin(), is_clipped_.end(), 0) -
                            is_clipped_.begin());
  }

  double AreaOf(const Triangle& t) const {
    return Cross(corners_[t[0]], corners_[t[1]], corners_[t[2]]);
  }

  Triangle EarAt(int at) const { return {before_[at], at, next_[at]}; }

  void Add(const Triangle& triangle) {
    if (AreaOf(triangle) != 0) triangles_.push_back(triangle);
  }

  bool IsEar(int at) const {
    const Triangle ear = EarAt(at);
    const double area = AreaOf(ear);
    if (area == 0) return true;  // a corner on a straight side
    if (area < 0) return false;
    for (int other = next_[ear[2]]; other != ear[0]; other = next_[other]) {
      if (IsInside(ear, corners_[other])) return false;
    }
    return true;
  }

  // Inside or on the border; the corners of the triangle are not.
  bool IsInside(const Triangle& t, const Eigen::Vector2d& point) const {
    for (int k = 0; k < 3; ++k) {
      if (point == corners_[t[k]]) return false;
      if (Cross(corners_[t[k]], corners_[t[(k + 1) % 3]], point) < 0) return false;
    }
    return true;
  }

  std::vector<Eigen::Vector2d> corners_;
  std::vector<int> before_;
  std::vector<int> next_;
  std::vector<uint8_t> is_known_;  // not to be an ear
  std::vector<uint8_t> is_clipped_ = std::vector<uint8_t>(corners_.size());
  int num_rounds_ = 0;
  std::vector<Triangle> triangles_;
};

}  // namespace

Eigen::Vector3d PolygonAreaVector(std::span<const Eigen::Vector3d> corners) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
  }
  return sum;
}

std::vector<Triangle> TriangulatePolygon(std::span<const Eigen::Vector3d> corners) {
  if (corners.size() < 3) return {};
  return EarClipper(Flatten(corners)).Run();
}

}  // namespace limn
