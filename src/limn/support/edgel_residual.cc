#include "limn/support/edgel_residual.h"

#include <cmath>

namespace limn {

EdgelLine::EdgelLine(const Edgel& edgel) : position_px(edgel.position_px) {
  const Eigen::Matrix2d stored_from_virtual = edgel.stored_from_virtual.cast<double>();
  const Eigen::Vector2d tangent = (stored_from_virtual * edgel.Tangent()).normalized();
  across = stored_from_virtual.transpose() * Eigen::Vector2d(tangent.y(), -tangent.x());
}

std::optional<EdgelResidual> ResidualToEdgel(const View& view, const EdgelLine& line,
                                             const Eigen::Vector3d& point_in_world) {
  return ResidualToEdgel(view.camera, view.cam_from_world, line, point_in_world);
}

std::optional<EdgelResidual> ResidualToEdgel(const PinholeCamera& camera,
                                             const Rigid3d& cam_from_world, const EdgelLine& line,
                                             const Eigen::Vector3d& point_in_world) {
  const Eigen::Vector3d point = cam_from_world * point_in_world;
  if (!(point.z() > 0)) return std::nullopt;
  const Eigen::Vector2d pixel = camera.Project(point);
  const Eigen::Vector2d& row = line.across;
  const double fx = camera.fx / point.z();
  const double fy = camera.fy / point.z();
  const Eigen::Vector3d gradient_in_cam(
      row.x() * fx, row.y() * fy,
      -(row.x() * fx * point.x() + row.y() * fy * point.y()) / point.z());
  return EdgelResidual{row.dot(pixel - line.position_px),
                       cam_from_world.rotation.conjugate() * gradient_in_cam};
}

double ResidualVariance(const Edgel& edgel) {
  constexpr double kModelSigmaPx = 0.2;
  return edgel.position_sigma_px * edgel.position_sigma_px + kModelSigmaPx * kModelSigmaPx;
}

namespace {

// `point` is in the camera.
std::optional<double> DirectionAt(const View& view, const Eigen::Vector3d& point,
                                  const Eigen::Vector3d& tangent_in_world) {
  const Eigen::Vector3d tangent = view.cam_from_world.rotation * tangent_in_world;
  const double dx = view.camera.fx * (tangent.x() * point.z() - point.x() * tangent.z());
  const double dy = view.camera.fy * (tangent.y() * point.z() - point.y() * tangent.z());
  if (dx == 0 && dy == 0) return std::nullopt;
  const double direction = std::atan2(dy, dx);
  // Products with extreme numbers overflow.
  return std::isnan(direction) ? std::nullopt : std::optional(direction);
}

}  // namespace

std::optional<double> ProjectedDirection(const View& view, const Eigen::Vector3d& point_in_world,
                                         const Eigen::Vector3d& tangent_in_world) {
  const Eigen::Vector3d point = view.cam_from_world * point_in_world;
  if (!(point.z() > 0)) return std::nullopt;
  return DirectionAt(view, point, tangent_in_world);
}

std::optional<CurveSight> See(const View& view, const Eigen::Vector3d& point_in_world,
                              const Eigen::Vector3d& tangent_in_world) {
  const Eigen::Vector3d point = view.cam_from_world * point_in_world;
  if (!(point.z() > 0)) return std::nullopt;
  const Eigen::Vector2d pixel = view.camera.Project(point);
  if (!view.region.Contains(pixel)) return std::nullopt;
  const auto direction = DirectionAt(view, point, tangent_in_world);
  if (!direction) return std::nullopt;
  return CurveSight{pixel, *direction};
}

}  // namespace limn
