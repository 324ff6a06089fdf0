// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace limn {

// Positions on a polyline of at least two points: the index of a point plus the fraction of the way
// to the next one. Positions before the first or beyond the last point are on the straight line
// through the first or last two. Constant time.

// The point before a position, and the fraction.
inline std::pair<size_t, double> SegmentAt(double position, size_t num_points) {
  const auto i = std::min(static_cast<size_t>(std::max(position, 0.0)), num_points - 2);
  return {i, position - static_cast<double>(i)};
}

template <typename Point>
Point PointAtPosition(const std::vector<Point>& points, double position) {
  const auto [i, t] = SegmentAt(position, points.size());
  return (1 - t) * points[i] + t * points[i + 1];
}

// The arc length at a position, from those of the points (CumulativeLength).
inline double LengthAtPosition(const std::vector<double>& lengths, double position) {
  const auto [i, t] = SegmentAt(position, lengths.size());
  return lengths[i] + t * (lengths[i + 1] - lengths[i]);
}

}  // namespace limn
