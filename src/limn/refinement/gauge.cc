#include "limn/refinement/gauge.h"

#include <cmath>

namespace limn {

namespace {

// Root of the sum of squared distances of the camera centers from their mean.
double Spread(const std::vector<View>& views) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const View& view : views) mean += view.CenterInWorld() / static_cast<double>(views.size());
  double sum = 0;
  for (const View& view : views) sum += (view.CenterInWorld() - mean).squaredNorm();
  return std::sqrt(sum);
}

}  // namespace

Eigen::Affine3d GivenFromRefined(const std::vector<View>& given, const std::vector<View>& refined,
                                 const Eigen::Vector3d& middle) {
  const auto num_points = static_cast<Eigen::Index>(4 * given.size());
  double mean_arm = 0;
  for (const View& view : given) {
    mean_arm += (view.CenterInWorld() - middle).norm() / static_cast<double>(given.size());
  }
  // Centers that coincide tell no scale.
  const double spread = Spread(given);
  const double scale = spread > 1e-6 * mean_arm ? Spread(refined) / spread : 1;
  Eigen::Matrix3Xd from(3, num_points);
  Eigen::Matrix3Xd to(3, num_points);
  for (size_t v = 0; v < given.size(); ++v) {
    const double arm = (given[v].CenterInWorld() - middle).norm();
    const auto first = static_cast<Eigen::Index>(4 * v);
    const auto set = [&](const View& view, double length, Eigen::Matrix3Xd* points) {
      const Rigid3d world_from_cam = Inverse(view.cam_from_world);
      points->col(first) = world_from_cam.translation;
      for (int axis = 0; axis < 3; ++axis) {
        points->col(first + 1 + axis) = world_from_cam * (length * Eigen::Vector3d::Unit(axis));
      }
    };
    set(given[v], arm, &to);
    set(refined[v], scale * arm, &from);
  }
  const Eigen::Matrix4d similarity = Eigen::umeyama(from, to, true);
  return similarity.allFinite() ? Eigen::Affine3d(similarity) : Eigen::Affine3d::Identity();
}

std::vector<View> Moved(const std::vector<View>& views, const Eigen::Affine3d& similarity) {
  const double scale = std::cbrt(similarity.linear().determinant());
  const Eigen::Quaterniond turn(Eigen::Matrix3d(similarity.linear() / scale));
  std::vector<View> moved = views;
  for (View& view : moved) {
    const Eigen::Vector3d center = similarity * view.CenterInWorld();
    view.cam_from_world.rotation = (view.cam_from_world.rotation * turn.conjugate()).normalized();
    view.cam_from_world.translation = -(view.cam_from_world.rotation * center);
  }
  return moved;
}

}  // namespace limn
