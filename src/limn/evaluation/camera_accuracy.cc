// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/camera_accuracy.h"

#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "limn/model/camera_rays.h"
#include "limn/util/angles.h"
#include "limn/util/median.h"

namespace limn {

namespace {

double MedianAngleOfRays(const View& view, const View& truth) {
  const RayPairs rays = RaysThroughSamePixels(view, truth);
  const Eigen::Quaterniond turn =
      truth.cam_from_world.rotation * view.cam_from_world.rotation.conjugate();
  const Eigen::Matrix3Xd of_view = turn.toRotationMatrix() * rays.first;
  std::vector<double> angles;
  for (Eigen::Index i = 0; i < of_view.cols(); ++i) {
    const Eigen::Vector3d ray = of_view.col(i), true_ray = rays.second.col(i);
    angles.push_back(std::atan2(ray.cross(true_ray).norm(), ray.dot(true_ray)));
  }
  return Median(std::move(angles));
}

}  // namespace

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
