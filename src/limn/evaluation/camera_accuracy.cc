#include "limn/evaluation/camera_accuracy.h"

#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "limn/util/angles.h"
#include "limn/util/median.h"

namespace limn {

namespace {

// Pixels of an image that are compared, along each side.
constexpr int kGridSize = 9;

// Directions in the coordinates of two cameras, a pixel per column.
struct RayPairs {
  Eigen::Matrix3Xd of_view, of_truth;
};

std::optional<Eigen::Vector3d> Ray(const View& view, const Eigen::Vector2d& stored_px) {
  const auto virtual_px = view.VirtualFromStored(stored_px);
  if (!virtual_px) return std::nullopt;
  return view.camera.RayFromPixel(*virtual_px).normalized();
}

RayPairs RaysThroughSamePixels(const View& view, const View& truth) {
  const Eigen::Vector2d size(truth.camera.width, truth.camera.height);
  constexpr int kNumPixels = kGridSize * kGridSize;
  RayPairs rays = {Eigen::Matrix3Xd(3, kNumPixels), Eigen::Matrix3Xd(3, kNumPixels)};
  int count = 0;
  for (int i = 0; i < kNumPixels; ++i) {
    const int row = i / kGridSize;
    const Eigen::Vector2d cell(i % kGridSize + 0.5, row + 0.5);
    const Eigen::Vector2d pixel = size.cwiseProduct(cell) / kGridSize;
    const auto ray = Ray(view, pixel);
    const auto true_ray = Ray(truth, pixel);
    if (!ray || !true_ray) continue;
    rays.of_view.col(count) = *ray;
    rays.of_truth.col(count) = *true_ray;
    ++count;
  }
  rays.of_view.conservativeResize(Eigen::NoChange, count);
  rays.of_truth.conservativeResize(Eigen::NoChange, count);
  return rays;
}

double MedianAngleOfRays(const View& view, const View& truth) {
  const RayPairs rays = RaysThroughSamePixels(view, truth);
  const Eigen::Quaterniond turn =
      truth.cam_from_world.rotation * view.cam_from_world.rotation.conjugate();
  const Eigen::Matrix3Xd of_view = turn.toRotationMatrix() * rays.of_view;
  std::vector<double> angles;
  for (Eigen::Index i = 0; i < of_view.cols(); ++i) {
    const Eigen::Vector3d ray = of_view.col(i), true_ray = rays.of_truth.col(i);
    angles.push_back(std::atan2(ray.cross(true_ray).norm(), ray.dot(true_ray)));
  }
  return Median(std::move(angles));
}

}  // namespace

View WithRaysInTrueOptics(View view, const View& truth) {
  const RayPairs rays = RaysThroughSamePixels(view, truth);
  if (rays.of_view.cols() == 0) return view;
  const auto with_opposites = [](const Eigen::Matrix3Xd& directions) {
    Eigen::Matrix3Xd both(3, 2 * directions.cols());
    both << directions, -directions;
    return both;
  };
  // Opposite rays have their mean at the center, so that the fit does not move it.
  const Eigen::Matrix4d turn =
      Eigen::umeyama(with_opposites(rays.of_view), with_opposites(rays.of_truth), false);
  Rigid3d motion;
  motion.rotation = Eigen::Quaterniond(Eigen::Matrix3d(turn.topLeftCorner<3, 3>())).normalized();
  view.cam_from_world = motion * view.cam_from_world;
  return view;
}

CameraAccuracy MeasureCameraAccuracy(const std::vector<View>& views,
                                     const std::vector<View>& true_views) {
  std::vector<double> centers, angles, shifts_px, rays_px, focals;
  for (size_t v = 0; v < views.size(); ++v) {
    const View& view = views[v];
    const View& truth = true_views[v];
    const double focal = truth.camera.MeanFocal();
    const double angle =
        view.cam_from_world.rotation.angularDistance(truth.cam_from_world.rotation);
    centers.push_back((view.CenterInWorld() - truth.CenterInWorld()).norm());
    angles.push_back(Degrees(angle));
    shifts_px.push_back(angle * focal);
    rays_px.push_back(MedianAngleOfRays(view, truth) * focal);
    focals.push_back(std::abs(view.camera.MeanFocal() / focal - 1));
  }
  CameraAccuracy accuracy;
  accuracy.num_views = views.size();
  accuracy.center = Median(std::move(centers));
  accuracy.rotation_deg = Median(std::move(angles));
  accuracy.rotation_px = Median(std::move(shifts_px));
  accuracy.ray_px = Median(std::move(rays_px));
  accuracy.focal = Median(std::move(focals));
  return accuracy;
}

}  // namespace limn
