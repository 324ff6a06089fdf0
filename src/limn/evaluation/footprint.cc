#include "limn/evaluation/footprint.h"

#include <algorithm>
#include <limits>

namespace limn {

double PixelFootprint(const std::vector<View>& views, const Eigen::Vector3d& point_in_world) {
  std::vector<double> seeing;
  std::vector<double> facing;
  double least_distance = std::numeric_limits<double>::infinity();
  for (const View& view : views) {
    const Eigen::Vector3d point_in_cam = view.cam_from_world * point_in_world;
    least_distance = std::min(least_distance, point_in_cam.norm() / view.camera.MeanFocal());
    const double depth = point_in_cam.z();
    if (!(depth > 0)) continue;
    facing.push_back(depth / view.camera.MeanFocal());
    if (view.Project(point_in_world)) seeing.push_back(facing.back());
  }
  std::vector<double>& footprints = seeing.empty() ? facing : seeing;
  if (footprints.empty()) {
    return std::max(least_distance, std::numeric_limits<double>::min());
  }
  const auto middle = footprints.begin() + footprints.size() / 2;
  std::nth_element(footprints.begin(), middle, footprints.end());
  return *middle;
}

double FootprintOfCurve(const std::vector<View>& views, const Polyline3d& curve) {
  if (curve.empty()) return 1;
  const double length = Length(curve);
  return PixelFootprint(views,
                        length > 0 ? ResampleUniform(curve, 0.5 * length)[1] : curve.front());
}

}  // namespace limn
