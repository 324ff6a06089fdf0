// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/world_shift.h"

#include <utility>

#include "colmap_ext/model/scene_origin.h"
#include "limn/model/drawing_transform.h"

namespace limn::colmap_ext {

DrawingGraph Moved(DrawingGraph graph, const Eigen::Vector3d& shift) {
  return Transformed(std::move(graph), 1, Eigen::Matrix3d::Identity(), shift);
}

CurveSketch Moved(CurveSketch sketch, const Eigen::Vector3d& shift) {
  for (Curve3D& curve : sketch.curves) {
    for (Eigen::Vector3d& point : curve.points_in_world) point += shift;
  }
  return sketch;
}

std::vector<View> Moved(std::vector<View> views, const Eigen::Vector3d& shift) {
  for (View& view : views) view.cam_from_world = Moved(view.cam_from_world, shift);
  return views;
}

std::optional<Eigen::AlignedBox3d> Moved(std::optional<Eigen::AlignedBox3d> box,
                                         const Eigen::Vector3d& shift) {
  if (box) box->translate(shift);
  return box;
}

}  // namespace limn::colmap_ext
