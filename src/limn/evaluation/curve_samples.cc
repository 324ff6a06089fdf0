// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/curve_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "limn/util/errors.h"

namespace limn {
namespace {

// Throws InputError if there would be more.
void CheckNumCells(double length, double step, int num_before, int max_cells) {
  const double num_cells = num_before + length / step;
  if (num_cells <= max_cells) return;
  std::ostringstream text;
  text << "the curves are too long: " << num_cells << " steps of length " << step
       << ", but at most " << max_cells << " (is the unit right?)";
  throw InputError(text.str());
}

// `num_intervals` equal arc-length intervals of a polyline of positive length.
void AppendEqualIntervals(const Polyline3d& polyline, const std::vector<double>& lengths,
                          int num_intervals, std::vector<Eigen::Vector3d>* points) {
  size_t segment = 0;
  for (int k = 0; k < num_intervals; ++k) {
    const double at = lengths.back() * k / num_intervals;
    while (segment + 2 < polyline.size() && lengths[segment + 1] <= at) ++segment;
    const double segment_length = lengths[segment + 1] - lengths[segment];
    const double t = segment_length > 0 ? (at - lengths[segment]) / segment_length : 0.0;
    points->push_back(polyline[segment] + t * (polyline[segment + 1] - polyline[segment]));
  }
  points->push_back(polyline.back());
}

}  // namespace

CurveSamples::CurveSamples(const CurveSet& set,
                           const std::function<double(const Polyline3d&)>& step_of, int max_cells)
    : index_({}) {
  for (const Polyline3d& polyline : set.polylines) {
    AddPolyline(polyline, step_of(polyline), max_cells);
  }
  if (set.polylines.empty()) {
    for (const Eigen::Vector3d& point : set.points) AddPoint(point);
  }
  index_ = MakeIndex();
}

SpatialIndex CurveSamples::MakeIndex() const {
  std::vector<Eigen::Vector3d> positions;
  positions.reserve(curve_of_.size());
  for (int sample = 0; sample < size(); ++sample) positions.push_back(Position(sample));
  return SpatialIndex(positions);
}

void CurveSamples::AddPoint(const Eigen::Vector3d& point) {
  points_.insert(points_.end(), 3, point);
  curve_of_.push_back(static_cast<int>(weight_of_curve_.size()));
  weight_of_curve_.push_back(1.0);
}

void CurveSamples::AddPolyline(const Polyline3d& polyline, double step, int max_cells) {
  const std::vector<double> lengths = CumulativeLength(polyline);
  const double length = lengths.empty() ? 0.0 : lengths.back();
  if (!(length > 0)) {
    // Keeps the numbering of curves: one cell of weight 0 where the degenerate curve is.
    if (polyline.empty()) {
      points_.push_back(Eigen::Vector3d::Zero());
    } else {
      points_.insert(points_.end(), 3, polyline.front());
      curve_of_.push_back(static_cast<int>(weight_of_curve_.size()));
    }
    weight_of_curve_.push_back(0.0);
    return;
  }
  CheckNumCells(length, step, size(), max_cells);
  // The allowance keeps a length of exactly n steps at n cells in spite of rounding.
  const int num_cells = std::max(1, static_cast<int>(std::ceil(length / step * (1 - 1e-12))));
  AppendEqualIntervals(polyline, lengths, 2 * num_cells, &points_);
  curve_of_.insert(curve_of_.end(), num_cells, static_cast<int>(weight_of_curve_.size()));
  weight_of_curve_.push_back(length / num_cells);
  longest_half_cell_ = std::max(longest_half_cell_, 0.5 * length / num_cells);
}

Eigen::Vector3d CurveSamples::Direction(int sample) const {
  const std::span<const Eigen::Vector3d> cell = Cell(sample);
  const Eigen::Vector3d chord = cell[2] - cell[0];
  const double length = chord.norm();
  return length > 0 ? Eigen::Vector3d(chord / length) : Eigen::Vector3d::Zero();
}

double CurveSamples::Distance(const Eigen::Vector3d& query) const {
  if (size() == 0) return std::numeric_limits<double>::infinity();
  const int nearest = index_.Nearest(query).index;
  double squared = ClosestPoint(Cell(nearest), query).squared_distance;
  if (!IsFirst(nearest)) {
    squared = std::min(squared, ClosestPoint(Cell(nearest - 1), query).squared_distance);
  }
  if (!IsLast(nearest)) {
    squared = std::min(squared, ClosestPoint(Cell(nearest + 1), query).squared_distance);
  }
  return std::sqrt(squared);
}

void CurveSamples::FindNear(const Eigen::Vector3d& query, double radius,
                            std::vector<SpatialIndex::Neighbor>* found) const {
  index_.FindWithin(query, radius + longest_half_cell_, found);
}

}  // namespace limn
