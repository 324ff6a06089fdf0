// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "limn/geometry/spatial_index.h"
#include "limn/model/curve_set.h"

namespace limn {

// Curves cut into cells of equal arc length, each represented by the sample in its middle, so that
// sums over samples are integrals over length. The samples of a set without polylines are its
// points, each of weight 1; otherwise points are ignored.
class CurveSamples {
 public:
  // About 1.5 GB.
  static constexpr int kMaxCells = 15'000'000;

  // step_of(polyline) > 0: the longest allowed cell. Throws InputError for more than max_cells.
  CurveSamples(const CurveSet& set, const std::function<double(const Polyline3d&)>& step_of,
               int max_cells = kMaxCells);

  int size() const { return static_cast<int>(curve_of_.size()); }
  int CurveOf(int sample) const { return curve_of_[sample]; }
  // Length of the sample's cell, or 1 for a point.
  double Weight(int sample) const { return weight_of_curve_[curve_of_[sample]]; }
  const Eigen::Vector3d& Position(int sample) const { return *(CellBegin(sample) + 1); }
  // Unit direction of the cell's chord; zero for a point.
  Eigen::Vector3d Direction(int sample) const;
  bool IsFirst(int sample) const { return sample == 0 || CurveOf(sample - 1) != CurveOf(sample); }
  bool IsLast(int sample) const {
    return sample + 1 == size() || CurveOf(sample + 1) != CurveOf(sample);
  }
  // Begin, middle and end of the cell: two segments.
  std::span<const Eigen::Vector3d> Cell(int sample) const { return {CellBegin(sample), 3}; }

  // Distance from a point to the curves, that is, to the cells around the nearest sample. Infinity
  // without samples.
  double Distance(const Eigen::Vector3d& query) const;

  // Samples whose cell may come within `radius` of the query, ascending.
  void FindNear(const Eigen::Vector3d& query, double radius,
                std::vector<SpatialIndex::Neighbor>* found) const;

 private:
  // Curve c with n cells owns 2n + 1 consecutive points.
  const Eigen::Vector3d* CellBegin(int sample) const {
    return &points_[2 * static_cast<size_t>(sample) + curve_of_[sample]];
  }
  void AddPolyline(const Polyline3d& polyline, double step, int max_cells);
  void AddPoint(const Eigen::Vector3d& point);
  SpatialIndex MakeIndex() const;

  std::vector<Eigen::Vector3d> points_;
  std::vector<int> curve_of_;
  std::vector<double> weight_of_curve_;
  double longest_half_cell_ = 0;
  SpatialIndex index_;
};

}  // namespace limn
