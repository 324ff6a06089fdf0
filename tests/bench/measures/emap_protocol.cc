// SPDX-License-Identifier: BSD-3-Clause
#include "bench/measures/emap_protocol.h"

#include <cmath>
#include <map>
#include <tuple>

#include "limn/geometry/polyline.h"
#include "limn/geometry/spatial_index.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// floor(length / spacing) points of each curve, evenly from its first to its last.
std::vector<Eigen::Vector3d> SamplePoints(const CurveSet& set, double spacing) {
  std::vector<Eigen::Vector3d> points;
  for (const Polyline3d& polyline : set.polylines) {
    const double length = Length(polyline);
    // The allowance keeps a length of exactly n steps at n points in spite of rounding.
    const int count = static_cast<int>(std::floor(length / spacing * (1 + 1e-9)));
    if (count == 1) points.push_back(polyline.front());
    if (count < 2) continue;
    const Polyline3d samples = ResampleUniform(polyline, length / (count - 1) * (1 + 1e-9));
    points.insert(points.end(), samples.begin(), samples.end());
  }
  if (set.polylines.empty()) points = set.points;
  return points;
}

struct Nearness {
  double mean = 0;
  std::vector<double> shares;  // nearer than each threshold
};

Nearness Measure(const std::vector<Eigen::Vector3d>& from, const std::vector<Eigen::Vector3d>& to,
                 const std::vector<double>& thresholds) {
  const SpatialIndex index(to);
  Nearness nearness;
  nearness.shares.assign(thresholds.size(), 0);
  const double weight = 1.0 / static_cast<double>(from.size());
  for (const Eigen::Vector3d& point : from) {
    const double distance = std::sqrt(index.Nearest(point).squared_distance);
    nearness.mean += weight * distance;
    for (size_t i = 0; i < thresholds.size(); ++i) {
      if (distance < thresholds[i]) nearness.shares[i] += weight;
    }
  }
  return nearness;
}

}  // namespace

void EmapOptions::Check() const {
  LIMN_CHECK_OPTION(spacing, > 0);
  LIMN_CHECK_OPTION(voxels_per_axis, > 0);
  LIMN_CHECK_OPTION(true_spacing, > 0);
}

std::vector<Eigen::Vector3d> AverageVoxels(const std::vector<Eigen::Vector3d>& points,
                                           int voxels_per_axis) {
  struct Cell {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int count = 0;
  };
  std::map<std::tuple<int, int, int>, Cell> cells;
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Array3i at =
        (0.5 * voxels_per_axis * (point.array() + 1)).floor().template cast<int>();
    Cell& cell = cells[{at.x(), at.y(), at.z()}];
    cell.sum += point;
    ++cell.count;
  }
  std::vector<Eigen::Vector3d> means;
  means.reserve(cells.size());
  for (const auto& [at, cell] : cells) means.push_back(cell.sum / cell.count);
  return means;
}

std::optional<EmapScores> EvaluateByEmap(const CurveSet& reconstruction, const CurveSet& truth,
                                         const EmapOptions& options) {
  options.Check();
  const std::vector<Eigen::Vector3d> true_points = SamplePoints(truth, options.true_spacing);
  if (true_points.empty()) throw InputError("ground truth: no curves and no points");
  std::vector<Eigen::Vector3d> points = SamplePoints(reconstruction, options.spacing);
  if (points.empty()) return std::nullopt;
  if (options.average_voxels) points = AverageVoxels(points, options.voxels_per_axis);

  const Nearness there = Measure(points, true_points, options.thresholds);
  const Nearness back = Measure(true_points, points, options.thresholds);
  EmapScores scores;
  scores.accuracy = there.mean;
  scores.completeness = back.mean;
  scores.num_points = static_cast<int>(points.size());
  for (size_t i = 0; i < options.thresholds.size(); ++i) {
    const double precision = there.shares[i];
    const double recall = back.shares[i];
    const double sum = precision + recall;
    scores.rows.push_back(
        {options.thresholds[i], precision, recall, sum > 0 ? 2 * precision * recall / sum : 0.0});
  }
  return scores;
}

}  // namespace limn
