#pragma once

#include <Eigen/Core>

#include "colmap_ext/model/model.h"

namespace limn::colmap_ext {

// Where to put the origin of the world while working on a model. Zero, unless the cameras are more
// than 1000 times as far from the model's origin as from each other (geo-referenced models: UTM
// coordinates are millions of meters): then a point amid them, whose coordinates are multiples of a
// power of ten above their distances. Numbers near zero keep all their digits, also in single
// precision. O(images).
Eigen::Vector3d SceneOrigin(const SparseModel& model);

// The same camera where every position has moved by `shift`: cam_from_world after the move.
Rigid3d Moved(const Rigid3d& cam_from_world, const Eigen::Vector3d& shift);

// Add `shift` to all positions: 3D points and camera centers.
void MoveModel(const Eigen::Vector3d& shift, SparseModel* model);

}  // namespace limn::colmap_ext
