#include "limn/model/reprojection_errors.h"

#include <cmath>
#include <utility>

#include "limn/util/median.h"

namespace limn {
namespace {

constexpr size_t kMinPointsOfView = 10;

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
                                                            const std::vector<ScenePoint>& points) {
  std::vector<std::vector<double>> errors(views.size());
  for (const ScenePoint& point : points) {
    for (const PointPixel& pixel : point.pixels) {
      errors[pixel.view].push_back(
          ReprojectionError(views[pixel.view], point.position_in_world, pixel));
    }
  }
  std::vector<std::optional<double>> medians(views.size());
  for (size_t v = 0; v < views.size(); ++v) {
    if (errors[v].size() >= kMinPointsOfView) medians[v] = Median(std::move(errors[v]));
  }
  return medians;
}

}  // namespace limn
