// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/footprint.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "limn/util/median.h"

namespace limn {

std::optional<double> FootprintIn(const View& view, const Eigen::Vector3d& point_in_world) {
  const double depth = (view.cam_from_world * point_in_world).z();
  if (!(depth > 0)) return std::nullopt;
  return depth / view.camera.MeanFocal();
}

double MedianFootprint(const Eigen::Vector3d& point_in_world, std::span<const ViewId> of_views,
                       const std::vector<View>& views) {
  std::vector<double> footprints;
  for (const ViewId id : of_views) {
    if (const auto footprint = FootprintIn(views[id], point_in_world)) {
      footprints.push_back(*footprint);
    }
  }
  return Median(std::move(footprints));
}

double LinkFootprint(const DrawingLink& link, const Eigen::Vector3d& point_in_world,
                     const std::vector<View>& views) {
  const double footprint = MedianFootprint(point_in_world, link.supporting_views, views);
  if (footprint > 0) return footprint;
  std::vector<ViewId> all(views.size());
  std::iota(all.begin(), all.end(), 0);
  return MedianFootprint(point_in_world, all, views);
}

double LinkFootprint(const DrawingLink& link, const std::vector<View>& views) {
  return LinkFootprint(link, link.points_in_world[link.points_in_world.size() / 2], views);
}

double PixelFootprint(const std::vector<View>& views, const Eigen::Vector3d& point_in_world) {
  std::vector<double> containing;
  std::vector<double> facing;
  for (const View& view : views) {
    const auto footprint = FootprintIn(view, point_in_world);
    if (!footprint) continue;
    facing.push_back(*footprint);
    if (view.Project(point_in_world)) containing.push_back(*footprint);
  }
  if (!containing.empty()) return Median(std::move(containing));
  if (!facing.empty()) return Median(std::move(facing));
  double least = std::numeric_limits<double>::infinity();
  for (const View& view : views) {
    least =
        std::min(least, (view.cam_from_world * point_in_world).norm() / view.camera.MeanFocal());
  }
  return std::max(least, std::numeric_limits<double>::min());
}

double FootprintOfCurve(const std::vector<View>& views, const Polyline3d& curve) {
  if (curve.empty()) return 1;
  const double length = Length(curve);
  return PixelFootprint(views,
                        length > 0 ? ResampleUniform(curve, 0.5 * length)[1] : curve.front());
}

}  // namespace limn
