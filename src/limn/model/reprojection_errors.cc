// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/reprojection_errors.h"

#include <cmath>
#include <utility>

#include "limn/util/median.h"

namespace limn {
namespace {

constexpr size_t kMinPointsOfImage = 10;

double ReprojectionError(const View& view, const Eigen::Vector3d& point, const PointPixel& pixel) {
  const double diagonal = std::hypot(view.camera.width, view.camera.height);
  const Eigen::Vector3d in_cam = view.cam_from_world * point;
  if (!(in_cam.z() > 0)) return diagonal;
  const Eigen::Vector2d miss = view.camera.Project(in_cam) - pixel.position_px;
  const double error = (pixel.stored_from_virtual * miss).norm();
  return error < diagonal ? error : diagonal;
}

}  // namespace

std::vector<std::optional<double>> MedianReprojectionErrors(const std::vector<View>& views,
                                                            const std::vector<ScenePoint>& points,
                                                            const std::vector<int>& image_of_view) {
  std::vector<std::vector<double>> errors(image_of_view.empty() ? 0 : image_of_view.back() + 1);
  for (const ScenePoint& point : points) {
    for (const PointPixel& pixel : point.pixels) {
      errors[image_of_view[pixel.view]].push_back(
          ReprojectionError(views[pixel.view], point.position_in_world, pixel));
    }
  }
  std::vector<std::optional<double>> medians(errors.size());
  for (size_t i = 0; i < errors.size(); ++i) {
    if (errors[i].size() >= kMinPointsOfImage) medians[i] = Median(std::move(errors[i]));
  }
  return medians;
}

}  // namespace limn
