// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "colmap_ext/model/model.h"

namespace limn::colmap_ext {

// The origin to use while working on a model, so that coordinates keep their digits, also in single
// precision. Zero, unless the cameras are more than 1000 times as far from the model's origin as
// from each other (geo-referenced models: UTM coordinates are millions of meters); then a point
// among them whose coordinates are multiples of a power of ten above their distances. O(images).
Eigen::Vector3d SceneOrigin(const SparseModel& model);

// The median of the cameras' centers, along each axis. Precondition: there are images.
Eigen::Vector3d MiddleOfCameras(const SparseModel& model);

// cam_from_world after all positions have moved by `shift`.
Rigid3d Moved(const Rigid3d& cam_from_world, const Eigen::Vector3d& shift);

// Adds `shift` to all positions: 3D points and camera centers.
void MoveModel(const Eigen::Vector3d& shift, SparseModel* model);

}  // namespace limn::colmap_ext
