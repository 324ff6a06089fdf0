// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "limn/cameras/camera_problem.h"
#include "limn/cameras/camera_scene.h"

namespace limn {

// Views whose cameras were off together, as those of one of two models that were merged, and have
// moved as one.
struct MovedPart {
  std::vector<ViewId> views;
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();  // a similarity of the world
};

std::vector<ViewId> ViewsOf(const CameraPart& part, const CameraMounts& mounts);

// The similarity by which a part of these views moved since `before`. `middle` is that of what they
// show (FindGauge).
MovedPart PartThatMoved(const CameraPart& part, const CameraScene& scene,
                        const std::vector<View>& before, const Eigen::Vector3d& middle);

// The views with all bodies on the other side: those of the part back where they were, the others
// moved as it was. Rigs keep their size.
std::vector<View> OnOtherSide(const CameraPart& part, const Eigen::Affine3d& motion,
                              const CameraScene& scene);

}  // namespace limn
