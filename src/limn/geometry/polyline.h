// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace limn {

using Polyline3d = std::vector<Eigen::Vector3d>;

// Arc length from the first vertex to each vertex; first is 0. Empty for an empty polyline.
std::vector<double> CumulativeLength(std::span<const Eigen::Vector3d> points);

double Length(std::span<const Eigen::Vector3d> points);

// A place on a polyline: between vertex `segment` and the next one, at `t` in [0, 1].
struct PolylinePoint {
  int segment = 0;
  double t = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double squared_distance = 0;
};

// The closest point of a polyline of at least two vertices; the first on ties. Linear time.
PolylinePoint ClosestPoint(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& query);

// Samples at equal arc-length steps no longer than `max_step` > 0, first and last vertex included.
// A polyline of zero length gives its first vertex.
Polyline3d ResampleUniform(std::span<const Eigen::Vector3d> points, double max_step);

// The part between two arc lengths, 0 <= from <= to <= length, with all vertices in between; at
// least two points. At arc length 0 and at the full length the vertices are kept bit for bit.
// Linear time. Precondition: at least two vertices.
Polyline3d CutPolyline(std::span<const Eigen::Vector3d> points, double from, double to);

// The vertices, with the first and last, through which a polyline is within `max_distance` of all
// others (Douglas & Peucker 1973). Time n log n, quadratic at worst.
Polyline3d Simplified(std::span<const Eigen::Vector3d> points, double max_distance);

}  // namespace limn
