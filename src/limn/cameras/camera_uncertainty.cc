// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cameras/camera_uncertainty.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "limn/cameras/pixel_by_point.h"
#include "limn/geometry/polyline.h"
#include "limn/support/edgel_residual.h"

namespace limn {
namespace {

// The unknowns of a view's camera, and how the image of a point moves with them, px.
struct ImageMotion {
  std::vector<int> unknowns;
  Eigen::Matrix2Xd by_unknowns;
};

Eigen::Matrix<double, 2, 6> PixelByBody(const CameraUncertainty& cameras, const View& view,
                                        const CameraMount& mount, const Eigen::Vector3d& point) {
  const Eigen::Vector3d in_body = Inverse(mount.view_from_body) * point;
  Eigen::Matrix<double, 3, 6> by_body;
  // A turn t moves the point by t x point.
  by_body.leftCols<3>() = Eigen::Matrix3d::Identity().colwise().cross(in_body);
  by_body.rightCols<3>() = cameras.shift_unit * Eigen::Matrix3d::Identity();
  return PixelByPoint(view.camera, point) * mount.view_from_body.rotation.toRotationMatrix() *
         by_body;
}

void AddUnknowns(int first, Eigen::Index count, std::vector<int>* unknowns) {
  for (Eigen::Index i = 0; i < count; ++i) unknowns->push_back(first + static_cast<int>(i));
}

// Of a point in front of the camera. The lens, between the image as stored and that of a pinhole,
// is taken as the identity, except for its parameters.
ImageMotion MotionOfImage(const CameraUncertainty& cameras, const View& view,
                          const CameraMount& mount, const Eigen::Vector3d& point_in_world) {
  const Eigen::Vector3d point = view.cam_from_world * point_in_world;
  ImageMotion motion;
  Eigen::Matrix2Xd by_parameters(2, 0);
  const auto at = cameras.covariance.camera_at.find(view.camera_index);
  if (at != cameras.covariance.camera_at.end()) {
    const Eigen::VectorXd& per_px = cameras.parameters_per_px.at(view.camera_index);
    if (const auto columns = view.calibration->StoredByParameters(view.camera.Project(point))) {
      by_parameters = *columns * per_px.asDiagonal();
    }
  }
  const int body_at = cameras.covariance.body_at[mount.body];
  const Eigen::Index of_body = body_at >= 0 ? 6 : 0;
  if (of_body > 0) AddUnknowns(body_at, of_body, &motion.unknowns);
  if (by_parameters.cols() > 0) AddUnknowns(at->second, by_parameters.cols(), &motion.unknowns);
  motion.by_unknowns.resize(2, of_body + by_parameters.cols());
  if (of_body > 0) motion.by_unknowns.leftCols<6>() = PixelByBody(cameras, view, mount, point);
  motion.by_unknowns.rightCols(by_parameters.cols()) = by_parameters;
  return motion;
}

// How a point of a curve moves in the two directions across it with the unknowns of its views, so
// that its images stay on the edges.
class MotionOfCurve {
 public:
  MotionOfCurve(const Eigen::Vector3d& point, const Eigen::Vector3d& tangent)
      : point_(point), tangent_(tangent) {
    across_.col(0) = tangent.unitOrthogonal();
    across_.col(1) = tangent.cross(across_.col(0));
  }

  void AddView(const CameraUncertainty& cameras, const View& view, const CameraMount& mount) {
    const auto sight = See(view, point_, tangent_);
    if (!sight) return;
    const Eigen::RowVector2d normal = sight->Across().transpose();
    const Eigen::RowVector2d by_motion = normal *
                                         PixelByPoint(view.camera, view.cam_from_world * point_) *
                                         view.cam_from_world.rotation.toRotationMatrix() * across_;
    const ImageMotion image = MotionOfImage(cameras, view, mount, point_);
    normal_ += by_motion.transpose() * by_motion;
    const auto first = by_unknowns_.cols();
    by_unknowns_.conservativeResize(2, first + image.by_unknowns.cols());
    by_unknowns_.rightCols(image.by_unknowns.cols()) =
        by_motion.transpose() * (normal * image.by_unknowns);
    unknowns_.insert(unknowns_.end(), image.unknowns.begin(), image.unknowns.end());
  }

  // Mean of the variances in the two directions; 0 if the views do not determine them.
  double Variance(const Eigen::MatrixXd& covariance) const {
    const double condition = normal_.determinant() / std::pow(normal_.trace(), 2);
    if (!(condition > kLeastCondition)) return 0;
    const Eigen::Matrix2Xd motion = normal_.inverse() * by_unknowns_;
    const double sum = (motion * covariance(unknowns_, unknowns_) * motion.transpose()).trace();
    return std::max(0.0, sum / 2);
  }

 private:
  static constexpr double kLeastCondition = 1e-9;

  Eigen::Vector3d point_;
  Eigen::Vector3d tangent_;
  Eigen::Matrix<double, 3, 2> across_;
  Eigen::Matrix2d normal_ = Eigen::Matrix2d::Zero();
  Eigen::Matrix2Xd by_unknowns_ = Eigen::Matrix2Xd(2, 0);
  std::vector<int> unknowns_;
};

}  // namespace

double CertainByPx(const CameraUncertainty& cameras, const std::vector<View>& views, ViewId view,
                   const Eigen::Vector3d& point_in_world) {
  if (!((views[view].cam_from_world * point_in_world).z() > 0)) return 0;
  const ImageMotion motion =
      MotionOfImage(cameras, views[view], cameras.mounts.of_view[view], point_in_world);
  const Eigen::MatrixXd covariance = cameras.covariance.matrix(motion.unknowns, motion.unknowns);
  const double sum = (motion.by_unknowns * covariance * motion.by_unknowns.transpose()).trace();
  return std::sqrt(std::max(0.0, sum / 2));
}

void AddShareOfCameras(const CameraUncertainty& cameras, const std::vector<View>& views,
                       const RunContext& context, DrawingGraph* graph) {
  ParallelFor(context, "uncertainty", graph->links.size(), [&](size_t l) {
    DrawingLink& link = graph->links[l];
    const Polyline3d& points = link.points_in_world;
    for (size_t k = 0; k < points.size(); ++k) {
      const Eigen::Vector3d along =
          points[std::min(k + 1, points.size() - 1)] - points[k > 0 ? k - 1 : 0];
      if (!(along.norm() > 0)) continue;
      MotionOfCurve motion(points[k], along.normalized());
      for (const ViewId view : link.supporting_views) {
        motion.AddView(cameras, views[view], cameras.mounts.of_view[view]);
      }
      link.sigma[k] =
          std::hypot(link.sigma[k], std::sqrt(motion.Variance(cameras.covariance.matrix)));
    }
  });
}

}  // namespace limn
