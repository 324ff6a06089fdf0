// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/camera_hints.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "limn/geometry/angle_between.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// How much the y axes count beside the x axes: they are tilted when cameras look up or down.
constexpr double kWeightOfDown = 0.1;
// Mean of the y axes, as unit vectors, below which they cancel: the cameras look straight down, as
// those of drones do, in any heading.
constexpr double kMinMeanDown = 0.3;
constexpr int kMedianRounds = 50;
// Of the angle between directions that are much the same.
constexpr double kCosOfSame = std::numbers::sqrt2 / 2;

Eigen::Vector3d DownInCam(const ViewPrior& prior) {
  return prior.gravity_in_cam ? prior.gravity_in_cam->normalized() : Eigen::Vector3d::UnitY();
}

// Of unit vectors: the direction with the least sum of angles to them (Weiszfeld's iteration);
// nothing if they cancel.
std::optional<Eigen::Vector3d> MedianDirection(const std::vector<Eigen::Vector3d>& directions) {
  Eigen::Vector3d median = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& direction : directions) median += direction;
  if (!(median.norm() > 1e-9 * static_cast<double>(directions.size()))) return std::nullopt;
  for (int k = 0; k < kMedianRounds; ++k) {
    median.normalize();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& direction : directions) {
      sum += direction / std::max(AngleBetween(direction, median), 1e-6);
    }
    median = sum;
  }
  return median.normalized();
}

}  // namespace

bool IsOrientationFlag(const Eigen::Vector3d& gravity_in_cam) {
  return gravity_in_cam.cwiseAbs().maxCoeff() > (1 - 1e-9) * gravity_in_cam.norm();
}

bool MeasuredGravity(const ViewPrior& prior) {
  return prior.gravity_in_cam && !IsOrientationFlag(*prior.gravity_in_cam);
}

std::optional<GravityUp> MeasuredUp(const std::vector<View>& views,
                                    const std::vector<ViewPrior>& priors) {
  std::vector<Eigen::Vector3d> directions;
  for (size_t v = 0; v < priors.size(); ++v) {
    if (!MeasuredGravity(priors[v])) continue;
    const Eigen::Vector3d down = priors[v].gravity_in_cam->normalized();
    directions.push_back(-(views[v].cam_from_world.rotation.conjugate() * down));
  }
  if (directions.size() < kMinGravities) return std::nullopt;
  const std::optional<Eigen::Vector3d> median = MedianDirection(directions);
  if (!median) return std::nullopt;
  GravityUp up;
  up.direction = *median;
  std::vector<double> angles;
  for (const Eigen::Vector3d& direction : directions) {
    angles.push_back(AngleBetween(direction, up.direction));
  }
  up.deviation_rad = Median(angles);
  up.num_views = directions.size();
  return up;
}

Eigen::Vector3d UpAsHeld(const View& view, const ViewPrior& prior) {
  return -(view.cam_from_world.rotation.conjugate() * DownInCam(prior));
}

Eigen::Vector3d UpOfCameras(const std::vector<View>& views, const std::vector<ViewPrior>& priors) {
  Eigen::Vector3d up = Eigen::Vector3d::Zero(), backward = Eigen::Vector3d::Zero();
  Eigen::Matrix3d horizontal = Eigen::Matrix3d::Zero();
  for (size_t v = 0; v < views.size(); ++v) {
    const Eigen::Quaterniond world_from_cam = views[v].cam_from_world.rotation.conjugate();
    const Eigen::Vector3d down = DownInCam(v < priors.size() ? priors[v] : ViewPrior());
    const Eigen::Vector3d right = world_from_cam * down.cross(Eigen::Vector3d::UnitZ());
    up -= world_from_cam * down;
    backward -= world_from_cam * Eigen::Vector3d::UnitZ();
    horizontal += right * right.transpose() / static_cast<double>(views.size());
  }
  if (up.norm() < kMinMeanDown * static_cast<double>(views.size())) up = backward;
  if (!(up.norm() > 1e-9)) up = -Eigen::Vector3d::UnitY();
  up.normalize();
  horizontal += kWeightOfDown * (Eigen::Matrix3d::Identity() - up * up.transpose());
  const Eigen::Vector3d least =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(horizontal).eigenvectors().col(0);
  return least.dot(up) < 0 ? -least : least;
}

Eigen::Vector3d MainViewDirection(const std::vector<View>& views) {
  Eigen::Matrix3Xd directions(3, views.size());
  for (size_t v = 0; v < views.size(); ++v) {
    directions.col(static_cast<Eigen::Index>(v)) =
        views[v].cam_from_world.rotation.conjugate() * Eigen::Vector3d::UnitZ();
  }
  const auto alike = [&](Eigen::Index v) {
    return (directions.transpose() * directions.col(v)).array() > kCosOfSame;
  };
  Eigen::Index best = 0, most = 0;
  for (Eigen::Index v = 0; v < directions.cols(); ++v) {
    const Eigen::Index count = alike(v).count();
    if (count > most) best = v;
    most = std::max(most, count);
  }
  const Eigen::VectorXd weights = alike(best).cast<double>();
  return (directions * weights).normalized();
}

}  // namespace limn
