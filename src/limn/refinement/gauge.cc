#include "limn/refinement/gauge.h"

#include <cmath>

namespace limn {

namespace {

Eigen::Matrix3Xd Centers(const std::vector<View>& views) {
  Eigen::Matrix3Xd centers(3, views.size());
  for (size_t v = 0; v < views.size(); ++v) centers.col(v) = views[v].CenterInWorld();
  return centers;
}

// Root of the sum of squared distances from the mean.
double Spread(const Eigen::Matrix3Xd& points) {
  return (points.colwise() - points.rowwise().mean()).norm();
}

// The center of every camera and the points one arm along its axes.
Eigen::Matrix3Xd CentersAndArms(const std::vector<View>& views, const Eigen::RowVectorXd& arms) {
  Eigen::Matrix3Xd points(3, 4 * views.size());
  for (size_t v = 0; v < views.size(); ++v) {
    const Rigid3d world_from_cam = Inverse(views[v].cam_from_world);
    auto of_view = points.middleCols<4>(4 * v);
    of_view << Eigen::Vector3d::Zero(), arms[v] * world_from_cam.rotation.toRotationMatrix();
    of_view.colwise() += world_from_cam.translation;
  }
  return points;
}

}  // namespace

Eigen::Affine3d GivenFromRefined(const std::vector<View>& given, const std::vector<View>& refined,
                                 const Eigen::Vector3d& middle) {
  const Eigen::Matrix3Xd centers = Centers(given);
  const Eigen::RowVectorXd arms = (centers.colwise() - middle).colwise().norm();
  // Coinciding centers determine no scale.
  const double spread = Spread(centers);
  const double scale = spread > 1e-6 * arms.mean() ? Spread(Centers(refined)) / spread : 1;
  const Eigen::Matrix4d similarity =
      Eigen::umeyama(CentersAndArms(refined, scale * arms), CentersAndArms(given, arms), true);
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
