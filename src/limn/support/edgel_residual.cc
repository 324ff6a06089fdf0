// SPDX-License-Identifier: BSD-3-Clause
#include "limn/support/edgel_residual.h"

namespace limn {

EdgelLine::EdgelLine(const Edgel& edgel) : position_px(edgel.position_px) {
  const Eigen::Matrix2d stored_from_virtual = edgel.stored_from_virtual.cast<double>();
  const Eigen::Vector2d tangent = (stored_from_virtual * edgel.Tangent()).normalized();
  across = stored_from_virtual.transpose() * Eigen::Vector2d(tangent.y(), -tangent.x());
}

std::optional<Eigen::Vector2d> ProjectedDirection(const View& view,
                                                  const Eigen::Vector3d& point_in_world,
                                                  const Eigen::Vector3d& tangent_in_world) {
  const Eigen::Vector3d point = view.cam_from_world * point_in_world;
  if (!(point.z() > 0)) return std::nullopt;
  return internal::DirectionAt(view, point, tangent_in_world);
}

}  // namespace limn
