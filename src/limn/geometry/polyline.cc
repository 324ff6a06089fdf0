// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/polyline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace limn {

std::vector<double> CumulativeLength(std::span<const Eigen::Vector3d> points) {
  std::vector<double> lengths(points.size(), 0.0);
  for (size_t i = 1; i < points.size(); ++i) {
    lengths[i] = lengths[i - 1] + (points[i] - points[i - 1]).norm();
  }
  return lengths;
}

double Length(std::span<const Eigen::Vector3d> points) {
  return points.empty() ? 0.0 : CumulativeLength(points).back();
}

PolylinePoint ClosestPoint(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& query) {
  PolylinePoint best;
  best.squared_distance = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    const Eigen::Vector3d along = points[i + 1] - points[i];
    const double squared_length = along.squaredNorm();
    const double t = squared_length > 0
                         ? std::clamp((query - points[i]).dot(along) / squared_length, 0.0, 1.0)
                         : 0.0;
    const Eigen::Vector3d foot = points[i] + t * along;
    const double squared_distance = (query - foot).squaredNorm();
    if (squared_distance < best.squared_distance) {
      best = {static_cast<int>(i), t, foot, squared_distance};
    }
  }
  return best;
}

Polyline3d ResampleUniform(std::span<const Eigen::Vector3d> points, double max_step) {
  if (points.empty()) return {};
  const std::vector<double> lengths = CumulativeLength(points);
  const double total = lengths.back();
  if (!(total > 0)) return {points.front()};
  const int num_steps = std::max(1, static_cast<int>(std::ceil(total / max_step)));
  Polyline3d samples;
  samples.reserve(num_steps + 1);
  size_t segment = 0;
  for (int k = 0; k < num_steps; ++k) {
    const double at = total * k / num_steps;
    while (segment + 2 < points.size() && lengths[segment + 1] <= at) ++segment;
    const double segment_length = lengths[segment + 1] - lengths[segment];
    const double t = segment_length > 0 ? (at - lengths[segment]) / segment_length : 0.0;
    samples.push_back(points[segment] + t * (points[segment + 1] - points[segment]));
  }
  samples.push_back(points.back());
  return samples;
}

Polyline3d CutPolyline(std::span<const Eigen::Vector3d> points, double from, double to) {
  const std::vector<double> lengths = CumulativeLength(points);
  const auto point_at = [&](double at) -> Eigen::Vector3d {
    if (at <= 0) return points.front();
    if (at >= lengths.back()) return points.back();
    const auto next = std::upper_bound(lengths.begin(), lengths.end(), at) - lengths.begin();
    const double t = (at - lengths[next - 1]) / (lengths[next] - lengths[next - 1]);
    return points[next - 1] + t * (points[next] - points[next - 1]);
  };
  Polyline3d part = {point_at(from)};
  for (size_t i = 1; i + 1 < points.size(); ++i) {
    if (lengths[i] > from && lengths[i] < to) part.push_back(points[i]);
  }
  part.push_back(point_at(to));
  return part;
}

Polyline3d Simplified(std::span<const Eigen::Vector3d> points, double max_distance) {
  std::vector<uint8_t> stays(points.size(), 0);
  std::vector<std::pair<size_t, size_t>> parts;
  if (!points.empty()) {
    stays.front() = stays.back() = 1;
    parts.emplace_back(0, points.size() - 1);
  }
  while (!parts.empty()) {
    const auto [begin, end] = parts.back();
    parts.pop_back();
    const std::array<Eigen::Vector3d, 2> chord = {points[begin], points[end]};
    size_t farthest = begin;
    double most = max_distance * max_distance;
    for (size_t i = begin + 1; i < end; ++i) {
      const double squared_distance = ClosestPoint(chord, points[i]).squared_distance;
      if (!(squared_distance > most)) continue;
      most = squared_distance;
      farthest = i;
    }
    if (farthest == begin) continue;
    stays[farthest] = 1;
    parts.emplace_back(begin, farthest);
    parts.emplace_back(farthest, end);
  }
  Polyline3d simplified;
  for (size_t i = 0; i < points.size(); ++i) {
    if (stays[i]) simplified.push_back(points[i]);
  }
  return simplified;
}

}  // namespace limn
