#pragma once

#include <optional>

#include <Eigen/Core>

#include "limn/model/edgel.h"
#include "limn/model/view.h"

namespace limn {

// The tangent line of an edgel, ready to be asked for distances.
struct EdgelLine {
  // NOLINTNEXTLINE(google-explicit-constructor): an edgel is as good where it is asked once.
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

// Nothing if the point is behind the camera.
std::optional<EdgelResidual> ResidualToEdgel(const View& view, const EdgelLine& line,
                                             const Eigen::Vector3d& point_in_world);
std::optional<EdgelResidual> ResidualToEdgel(const PinholeCamera& camera,
                                             const Rigid3d& cam_from_world, const EdgelLine& line,
                                             const Eigen::Vector3d& point_in_world);

// Variance of such a residual, px^2: what the edgel knows of its own position, and errors of
// calibration and sampling that it does not know of.
double ResidualVariance(const Edgel& edgel);

// Direction, radians, in the virtual image in which the point moves when it moves along the
// tangent. Nothing if the point is behind the camera or the tangent is seen end on.
std::optional<double> ProjectedDirection(const View& view, const Eigen::Vector3d& point_in_world,
                                         const Eigen::Vector3d& tangent_in_world);

// Where a view sees a point of a curve, and how the curve runs there, in the virtual image.
struct CurveSight {
  Eigen::Vector2d position_px = Eigen::Vector2d::Zero();
  double direction_rad = 0;
};

// Nothing if the point is behind the camera or outside the image, or the tangent is seen end on.
std::optional<CurveSight> See(const View& view, const Eigen::Vector3d& point_in_world,
                              const Eigen::Vector3d& tangent_in_world);

}  // namespace limn
