// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>

#include "limn/model/edgel.h"
#include "limn/model/view.h"

namespace limn {

// The tangent line of an edgel, prepared for distance queries (algorithm/notation.md#residual).
struct EdgelLine {
  // NOLINTNEXTLINE(google-explicit-constructor): convenient for single queries.
  EdgelLine(const Edgel& edgel);
  EdgelLine(const Eigen::Vector2d& position, const Eigen::Vector2d& row)
      : position_px(position), across(row) {}

  // A point of the line, virtual image.
  Eigen::Vector2d position_px;
  // The row that turns an offset in the virtual image into its part across the line, stored pixels.
  Eigen::Vector2d across;
};

// Signed distance, stored pixels, of a projected point from the tangent line of an edgel, and its
// gradient with respect to the point in the world.
struct EdgelResidual {
  double residual_px = 0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};

// What fits take for the distance of a point behind the camera, stored pixels: large, so that
// moving there never lowers the cost.
constexpr double kBehindCameraPx = 1e3;

// Empty if the point is behind the camera.
std::optional<EdgelResidual> ResidualToEdgel(const View& view, const EdgelLine& line,
                                             const Eigen::Vector3d& point_in_world);
std::optional<EdgelResidual> ResidualToEdgel(const PinholeCamera& camera,
                                             const Rigid3d& cam_from_world, const EdgelLine& line,
                                             const Eigen::Vector3d& point_in_world);

// Variance of such a residual, px^2: that of the edgel's own position plus that of calibration and
// sampling.
double ResidualVariance(const Edgel& edgel);

// Unit direction in the virtual image of a motion of the point along the tangent. Empty if the
// point is behind the camera or the tangent is seen end on, or not finite.
std::optional<Eigen::Vector2d> ProjectedDirection(const View& view,
                                                  const Eigen::Vector3d& point_in_world,
                                                  const Eigen::Vector3d& tangent_in_world);

// Position and direction of a point of a curve in the virtual image of a view.
struct CurveSight {
  Eigen::Vector2d position_px = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  // unit

  // Unit normal of the curve in the image.
  Eigen::Vector2d Across() const { return {-direction.y(), direction.x()}; }
};

// Empty if the point is behind the camera or outside the image, or if the tangent is seen end on.
std::optional<CurveSight> See(const View& view, const Eigen::Vector3d& point_in_world,
                              const Eigen::Vector3d& tangent_in_world);

// Inlined, since these are called for every sample of every curve in every view.

inline std::optional<EdgelResidual> ResidualToEdgel(const View& view, const EdgelLine& line,
                                                    const Eigen::Vector3d& point_in_world) {
  return ResidualToEdgel(view.camera, view.cam_from_world, line, point_in_world);
}

inline std::optional<EdgelResidual> ResidualToEdgel(const PinholeCamera& camera,
                                                    const Rigid3d& cam_from_world,
                                                    const EdgelLine& line,
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

inline double ResidualVariance(const Edgel& edgel) {
  constexpr double kModelSigmaPx = 0.2;
  return edgel.position_sigma_px * edgel.position_sigma_px + kModelSigmaPx * kModelSigmaPx;
}

namespace internal {

// `point` is in the camera.
inline std::optional<Eigen::Vector2d> DirectionAt(const View& view, const Eigen::Vector3d& point,
                                                  const Eigen::Vector3d& tangent_in_world) {
  const Eigen::Vector3d tangent = view.cam_from_world.rotation * tangent_in_world;
  const Eigen::Vector2d motion(
      view.camera.fx * (tangent.x() * point.z() - point.x() * tangent.z()),
      view.camera.fy * (tangent.y() * point.z() - point.y() * tangent.z()));
  const double length = motion.norm();
  // Products with extreme numbers overflow.
  if (!(length > 0 && std::isfinite(length))) return std::nullopt;
  return motion / length;
}

}  // namespace internal

inline std::optional<CurveSight> See(const View& view, const Eigen::Vector3d& point_in_world,
                                     const Eigen::Vector3d& tangent_in_world) {
  const Eigen::Vector3d point = view.cam_from_world * point_in_world;
  if (!(point.z() > 0)) return std::nullopt;
  const Eigen::Vector2d pixel = view.camera.Project(point);
  if (!view.region.Contains(pixel)) return std::nullopt;
  const auto direction = internal::DirectionAt(view, point, tangent_in_world);
  if (!direction) return std::nullopt;
  return CurveSight{pixel, *direction};
}

}  // namespace limn
