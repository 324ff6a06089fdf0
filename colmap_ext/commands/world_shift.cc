#include "colmap_ext/commands/world_shift.h"

namespace limn::colmap_ext {

DrawingGraph Moved(DrawingGraph graph, const Eigen::Vector3d& shift) {
  for (DrawingNode& node : graph.nodes) node.position_in_world += shift;
  for (DrawingLink& link : graph.links) {
    for (Eigen::Vector3d& point : link.points_in_world) point += shift;
    if (link.primitive) {
      link.primitive->shape =
          Transformed(link.primitive->shape, 1, Eigen::Matrix3d::Identity(), shift);
    }
  }
  return graph;
}

CurveSketch Moved(CurveSketch sketch, const Eigen::Vector3d& shift) {
  for (Curve3D& curve : sketch.curves) {
    for (Eigen::Vector3d& point : curve.points_in_world) point += shift;
  }
  return sketch;
}

std::optional<Eigen::AlignedBox3d> Moved(std::optional<Eigen::AlignedBox3d> box,
                                         const Eigen::Vector3d& shift) {
  if (box) box->translate(shift);
  return box;
}

}  // namespace limn::colmap_ext
