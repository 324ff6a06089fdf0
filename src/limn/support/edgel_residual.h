#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>

#include "limn/model/edgel.h"
#include "limn/model/view.h"

namespace limn {

// The tangent line of an edgel, prepared for distance queries (ALGORITHM.md 1.5).
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

// Empty if the point is behind the camera.
std::optional<EdgelResidual> ResidualToEdgel(const View& view, const EdgelLine& line,
                                             const Eigen::Vector3d& point_in_world);
std::optional<EdgelResidual> ResidualToEdgel(const PinholeCamera& camera,
                                             const Rigid3d& cam_from_world, const EdgelLine& line,
                                             const Eigen::Vector3d& point_in_world);

// Variance of such a residual, px^2: that of the edgel's own position plus that of calibration and
// sampling.
double ResidualVariance(const Edgel& edgel);

// Direction, radians, in the virtual image of a motion of the point along the tangent. Empty if the
// point is behind the camera or the tangent is seen end on, or not finite.
std::optional<double> ProjectedDirection(const View& view, const Eigen::Vector3d& point_in_world,
                                         const Eigen::Vector3d& tangent_in_world);

// Position and direction of a point of a curve in the virtual image of a view.
struct CurveSight {
  Eigen::Vector2d position_px = Eigen::Vector2d::Zero();
  double direction_rad = 0;

  // Unit normal of the curve in the image.
  Eigen::Vector2d Across() const { return {-std::sin(direction_rad), std::cos(direction_rad)}; }
};

// Empty if the point is behind the camera or outside the image, or if the tangent is seen end on.
std::optional<CurveSight> See(const View& view, const Eigen::Vector3d& point_in_world,
                              const Eigen::Vector3d& tangent_in_world);

}  // namespace limn
