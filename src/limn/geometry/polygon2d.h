// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace limn {

using Polyline2d = std::vector<Eigen::Vector2d>;

// Twice the area of the triangle between two vectors; positive if b is to the left of a.
inline double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}
// Twice the signed area of a triangle, positive if its corners go counterclockwise.
inline double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return Cross(b - a, c - a);
}

// Polygons in a plane, by their corners in order; the last is joined to the first.

// Counterclockwise is positive.
double SignedArea(std::span<const Eigen::Vector2d> corners);

double Perimeter(std::span<const Eigen::Vector2d> corners);

// A place on the outlines of a polygon: on the side of loop `loop` that begins at corner `corner`,
// at `t` in [0, 1].
struct OutlinePlace {
  int loop = -1;  // -1: none
  int corner = -1;
  double t = 0;
  double distance = 0;  // from the query
};

// A polygon with holes. All look-ups are linear in the number of corners.
struct Polygon2d {
  // The outer border first, then holes.
  std::vector<Polyline2d> outlines;

  // Inside the border and in no hole. On an outline it is arbitrary.
  bool Contains(const Eigen::Vector2d& point) const;
  double DistanceToOutline(const Eigen::Vector2d& point) const;
  // The first crossing of a ray with an outline; `direction` is a unit vector. None if the ray
  // meets none.
  OutlinePlace FirstCrossing(const Eigen::Vector2d& start, const Eigen::Vector2d& direction) const;
  double Area() const;
};

}  // namespace limn
