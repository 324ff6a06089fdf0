// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/polygon2d.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

// Calls visit(from, to, loop, corner) for every side.
template <typename Visit>
void ForEachSide(const std::vector<Polyline2d>& outlines, Visit&& visit) {
  for (size_t loop = 0; loop < outlines.size(); ++loop) {
    const Polyline2d& corners = outlines[loop];
    for (size_t i = 0; i < corners.size(); ++i) {
      visit(corners[i], corners[(i + 1) % corners.size()], static_cast<int>(loop),
            static_cast<int>(i));
    }
  }
}

double DistanceToSide(const Eigen::Vector2d& point, const Eigen::Vector2d& from,
                      const Eigen::Vector2d& to) {
  const Eigen::Vector2d side = to - from;
  const double length2 = side.squaredNorm();
  const double t = length2 > 0 ? std::clamp((point - from).dot(side) / length2, 0.0, 1.0) : 0;
  return (point - from - t * side).norm();
}

}  // namespace

double SignedArea(std::span<const Eigen::Vector2d> corners) {
  double twice = 0;
  for (size_t i = 1; i + 1 < corners.size(); ++i) {
    twice += Cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return twice / 2;
}

double Perimeter(std::span<const Eigen::Vector2d> corners) {
  double length = 0;
  for (size_t i = 0; i < corners.size(); ++i) {
    length += (corners[(i + 1) % corners.size()] - corners[i]).norm();
  }
  return length;
}

bool Polygon2d::Contains(const Eigen::Vector2d& point) const {
  bool is_inside = false;
  ForEachSide(outlines, [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to, int, int) {
    if ((from.y() > point.y()) == (to.y() > point.y())) return;
    const double x = from.x() + (point.y() - from.y()) / (to.y() - from.y()) * (to.x() - from.x());
    if (point.x() < x) is_inside = !is_inside;
  });
  return is_inside;
}

double Polygon2d::DistanceToOutline(const Eigen::Vector2d& point) const {
  double nearest = std::numeric_limits<double>::infinity();
  ForEachSide(outlines, [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to, int, int) {
    nearest = std::min(nearest, DistanceToSide(point, from, to));
  });
  return nearest;
}

OutlinePlace Polygon2d::FirstCrossing(const Eigen::Vector2d& start,
                                      const Eigen::Vector2d& direction) const {
  OutlinePlace first = {.distance = std::numeric_limits<double>::infinity()};
  ForEachSide(outlines,
              [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to, int loop, int corner) {
                const Eigen::Vector2d side = to - from;
                const double turn = Cross(direction, side);
                if (turn == 0) return;
                const double distance = Cross(from - start, side) / turn;
                const double t = Cross(from - start, direction) / turn;
                if (distance < 0 || distance >= first.distance || t < 0 || t > 1) return;
                first = {loop, corner, t, distance};
              });
  return first;
}

double Polygon2d::Area() const {
  double area = 0;
  for (size_t loop = 0; loop < outlines.size(); ++loop) {
    const double of_loop = std::abs(SignedArea(outlines[loop]));
    area += loop == 0 ? of_loop : -of_loop;
  }
  return area;
}

}  // namespace limn
