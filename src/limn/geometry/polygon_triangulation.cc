#include "limn/geometry/polygon_triangulation.h"

#include <numeric>

#include <Eigen/Geometry>

namespace limn {
namespace {

using Triangle = std::array<int, 3>;

// Twice the signed area, positive when a, b, c go counter-clockwise.
double Area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

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

// Clips ears off the corners that are left.
class EarClipper {
 public:
  explicit EarClipper(std::vector<Eigen::Vector2d> corners)
      : corners_(std::move(corners)), left_(corners_.size()) {
    std::iota(left_.begin(), left_.end(), 0);
  }

  std::vector<Triangle> Run() {
    size_t at = 0;
    size_t misses = 0;
    while (left_.size() > 3) {
      at %= left_.size();
      // When all corners have been refused the polygon is not simple: take the next one.
      if (misses < left_.size() && !IsEar(at)) {
        ++misses;
        ++at;
        continue;
      }
      Add(EarAt(at));
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
      misses = 0;
      // The next ear begins beyond this one, so that triangles do not become a fan of slivers.
      ++at;
    }
    Add({left_[0], left_[1], left_[2]});
    return std::move(triangles_);
  }

 private:
  double AreaOf(const Triangle& t) const {
    return Area(corners_[t[0]], corners_[t[1]], corners_[t[2]]);
  }

  Triangle EarAt(size_t at) const {
    const size_t count = left_.size();
    return {left_[(at + count - 1) % count], left_[at], left_[(at + 1) % count]};
  }

  void Add(const Triangle& triangle) {
    if (AreaOf(triangle) != 0) triangles_.push_back(triangle);
  }

  bool IsEar(size_t at) const {
    const Triangle ear = EarAt(at);
    const double area = AreaOf(ear);
    if (area == 0) return true;  // a corner on a straight side
    if (area < 0) return false;
    for (const int other : left_) {
      if (IsInside(ear, corners_[other])) return false;
    }
    return true;
  }

  // Inside or on the border; the corners of the triangle are not.
  bool IsInside(const Triangle& t, const Eigen::Vector2d& point) const {
    for (int k = 0; k < 3; ++k) {
      if (point == corners_[t[k]]) return false;
      if (Area(corners_[t[k]], corners_[t[(k + 1) % 3]], point) < 0) return false;
    }
    return true;
  }

  std::vector<Eigen::Vector2d> corners_;
  std::vector<int> left_;
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
