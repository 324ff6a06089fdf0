// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/drawing_transform.h"

namespace limn {
namespace {

Eigen::Matrix3d FromRows(const Eigen::RowVector3d& x, const Eigen::RowVector3d& y,
                         const Eigen::RowVector3d& z) {
  Eigen::Matrix3d matrix;
  matrix << x, y, z;
  return matrix;
}

}  // namespace

DrawingGraph Transformed(DrawingGraph graph, double scale, const Eigen::Matrix3d& rotation,
                         const Eigen::Vector3d& translation) {
  const Similarity3d similarity{scale, rotation, translation};
  const auto move = [&](Eigen::Vector3d* point) { *point = similarity * *point; };
  for (DrawingNode& node : graph.nodes) {
    move(&node.position_in_world);
    node.covariance = scale * scale * rotation * node.covariance * rotation.transpose();
  }
  for (DrawingLink& link : graph.links) {
    for (Eigen::Vector3d& point : link.points_in_world) move(&point);
    for (double& sigma : link.sigma) sigma *= scale;
    if (link.depth_sigma > 0) link.depth_sigma *= scale;
    link.rod_radius *= scale;
    if (link.body) link.body = Transformed(*link.body, similarity);
    if (link.primitive) {
      link.primitive->shape = Transformed(link.primitive->shape, scale, rotation, translation);
    }
  }
  graph.regularities = Transformed(std::move(graph.regularities), similarity);
  for (DrawingFace& face : graph.faces) face = Transformed(std::move(face), similarity);
  for (DrawingDimension& dimension : graph.dimensions) {
    dimension.from = similarity * dimension.from;
    dimension.to = similarity * dimension.to;
    dimension.shift = scale * (rotation * dimension.shift);
    dimension.sigma *= scale;
  }
  return graph;
}

Eigen::Matrix3d ZUpFrom(SignedAxis up) {
  const Eigen::RowVector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  switch (up) {
    case SignedAxis::kX:
      return FromRows(y, z, x);
    case SignedAxis::kY:
      return FromRows(x, -z, y);
    case SignedAxis::kZ:
      return FromRows(x, y, z);
    case SignedAxis::kMinusX:
      return FromRows(z, y, -x);
    case SignedAxis::kMinusY:
      return FromRows(x, z, -y);
    case SignedAxis::kMinusZ:
      return FromRows(x, -y, -z);
  }
  return Eigen::Matrix3d::Identity();
}

}  // namespace limn
