// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/normalized_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "limn/evaluation/quantiles.h"
#include "limn/geometry/spatial_index.h"
#include "limn/model/footprint.h"

namespace limn {
namespace {

// Polylines as segments of at most a footprint, to be asked for the offset of places near them.
class NearCurves {
 public:
  NearCurves(const CurveSet& curves, const std::vector<View>& views) : index_({}) {
    for (const Polyline3d& polyline : curves.polylines) {
      if (Length(polyline) > 0) Add(polyline, FootprintOfCurve(views, polyline));
    }
    index_ = SpatialIndex(middles_);
  }

  // Offset of the nearest segment across its direction. Nothing if none is within `reach`.
  std::optional<Eigen::Vector3d> OffsetAcross(const Eigen::Vector3d& query, double reach) const {
    std::vector<SpatialIndex::Neighbor> found;
    index_.FindWithin(query, reach + longest_half_, &found);
    double nearest = reach * reach;
    std::optional<Eigen::Vector3d> offset;
    for (const SpatialIndex::Neighbor& neighbor : found) {
      const std::array<Eigen::Vector3d, 2>& segment = segments_[neighbor.index];
      const PolylinePoint closest = ClosestPoint(segment, query);
      if (!(closest.squared_distance <= nearest)) continue;
      nearest = closest.squared_distance;
      const Eigen::Vector3d along = (segment[1] - segment[0]).normalized();
      const Eigen::Vector3d whole = query - closest.position;
      offset = whole - along * along.dot(whole);
    }
    return offset;
  }

 private:
  void Add(const Polyline3d& polyline, double step) {
    const Polyline3d points = ResampleUniform(polyline, step);
    for (size_t k = 1; k < points.size(); ++k) {
      segments_.push_back({points[k - 1], points[k]});
      middles_.push_back(0.5 * (points[k - 1] + points[k]));
      longest_half_ = std::max(longest_half_, 0.5 * (points[k] - points[k - 1]).norm());
    }
  }

  std::vector<std::array<Eigen::Vector3d, 2>> segments_;
  std::vector<Eigen::Vector3d> middles_;
  double longest_half_ = 0;
  SpatialIndex index_;
};

std::optional<double> Mean(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

NormalizedErrors MeasureNormalizedErrors(const DrawingGraph& drawing, const CurveSet& truth,
                                         const CurveSet& dont_care, const std::vector<View>& views,
                                         const NormalizedErrorOptions& options) {
  const NearCurves near_truth(truth, views);
  const NearCurves near_dont_care(dont_care, views);
  std::vector<double> squares;
  std::vector<double> squares_with_false;
  for (const DrawingLink& link : drawing.links) {
    for (size_t k = 0; k < link.points_in_world.size(); ++k) {
      const Eigen::Vector3d& point = link.points_in_world[k];
      const double variance = 2 * link.sigma[k] * link.sigma[k];
      if (!(variance > 0) || !std::isfinite(variance)) continue;
      if (options.region && !options.region->contains(point)) continue;
      const double footprint = PixelFootprint(views, point);
      if (const auto offset = near_truth.OffsetAcross(point, options.max_distance * footprint)) {
        squares.push_back(offset->squaredNorm() / variance);
        squares_with_false.push_back(squares.back());
        continue;
      }
      if (near_dont_care.OffsetAcross(point, options.dont_care_distance * footprint)) continue;
      // How far it is does not matter.
      squares_with_false.push_back(std::pow(options.max_distance * footprint, 2) / variance);
    }
  }
  NormalizedErrors errors;
  errors.num_inliers = static_cast<int>(squares.size());
  errors.num_false = static_cast<int>(squares_with_false.size() - squares.size());
  errors.variance = Mean(squares);
  errors.variance_with_false = Mean(squares_with_false);
  if (const auto median = Quantile(squares, 0.5)) errors.median_variance = *median / std::log(2);
  return errors;
}

}  // namespace limn
