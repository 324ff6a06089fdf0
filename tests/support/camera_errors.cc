// SPDX-License-Identifier: BSD-3-Clause
#include "support/camera_errors.h"

#include <random>

#include "limn/util/angles.h"
#include "support/random_numbers.h"

namespace limn::testing {
namespace {

// A map of the true world into that of the views.
using Similarity = Eigen::Affine3d;

Eigen::Vector2d ProjectAnywhere(const View& view, const Eigen::Vector3d& point) {
  return view.camera.Project(view.cam_from_world * point);
}

double MeanDisplacement(const std::vector<View>& views, const std::vector<View>& truth,
                        const std::vector<Eigen::Vector3d>& points, const Similarity& world) {
  double sum = 0;
  int count = 0;
  for (size_t v = 0; v < views.size(); ++v) {
    for (const Eigen::Vector3d& point : points) {
      const auto pixel = truth[v].Project(point);
      if (!pixel) continue;
      sum += (ProjectAnywhere(views[v], world * point) - *pixel).norm();
      ++count;
    }
  }
  return sum / count;
}

double DepthOfMiddle(const View& view, const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) center += point / static_cast<double>(points.size());
  return (view.cam_from_world * center).z();
}

// Six numbers per view: rotation and translation, in px of the middle of the points.
using Motions = std::vector<Eigen::Matrix<double, 6, 1>>;

std::vector<View> Moved(const std::vector<View>& views, const std::vector<Eigen::Vector3d>& points,
                        const Motions& motions, double scale) {
  std::vector<View> moved = views;
  for (size_t v = 0; v < views.size(); ++v) {
    const double focal = views[v].camera.MeanFocal();
    const Eigen::Vector3d turn = scale / focal * motions[v].head<3>();
    Rigid3d motion;
    motion.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized());
    motion.translation = scale * DepthOfMiddle(views[v], points) / focal * motions[v].tail<3>();
    moved[v].cam_from_world = motion * views[v].cam_from_world;
  }
  return moved;
}

Eigen::Matrix3Xd Centers(const std::vector<View>& views) {
  Eigen::Matrix3Xd centers(3, views.size());
  for (size_t v = 0; v < views.size(); ++v) {
    centers.col(static_cast<Eigen::Index>(v)) = views[v].CenterInWorld();
  }
  return centers;
}

}  // namespace

std::vector<View> PerturbCameras(const std::vector<View>& views,
                                 const std::vector<Eigen::Vector3d>& points, double mean_px,
                                 unsigned seed) {
  std::mt19937 random(seed);
  testing::NormalDistribution<double> gauss(0, 1);
  Motions motions(views.size());
  for (auto& motion : motions) {
    for (double& value : motion) value = gauss(random);
  }
  double scale = mean_px;
  // The displacement is all but proportional.
  for (int i = 0; i < 4; ++i) {
    scale *= mean_px / MeanDisplacement(Moved(views, points, motions, scale), views, points,
                                        Similarity::Identity());
  }
  return Moved(views, points, motions, scale);
}

Eigen::Affine3d WorldFromTruth(const std::vector<View>& views, const std::vector<View>& truth) {
  return Similarity(Eigen::umeyama(Centers(truth), Centers(views), true));
}

CameraErrors MeasureCameras(const std::vector<View>& views, const std::vector<View>& truth,
                            const std::vector<Eigen::Vector3d>& points) {
  const Similarity world = WorldFromTruth(views, truth);
  const double factor = std::cbrt(world.linear().determinant());
  const Eigen::Quaterniond turn(Eigen::Matrix3d(world.linear() / factor));
  CameraErrors errors;
  errors.raw_px = MeanDisplacement(views, truth, points, Similarity::Identity());
  errors.aligned_px = MeanDisplacement(views, truth, points, world);
  const double share = 1 / static_cast<double>(views.size());
  for (size_t v = 0; v < views.size(); ++v) {
    const Eigen::Quaterniond& rotation = truth[v].cam_from_world.rotation;
    errors.rotation_deg +=
        share * Degrees((views[v].cam_from_world.rotation * turn).angularDistance(rotation));
    errors.center +=
        share * (world * truth[v].CenterInWorld() - views[v].CenterInWorld()).norm() / factor;
  }
  return errors;
}

}  // namespace limn::testing
