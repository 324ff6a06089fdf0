#include "limn/geometry/polyline.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

}  // namespace limn
