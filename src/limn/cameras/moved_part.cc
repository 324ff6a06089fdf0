// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cameras/moved_part.h"

#include "limn/cameras/gauge.h"

namespace limn {

std::vector<ViewId> ViewsOf(const CameraPart& part, const CameraMounts& mounts) {
  std::vector<ViewId> views;
  for (size_t v = 0; v < mounts.of_view.size(); ++v) {
    if (part[mounts.of_view[v].body]) views.push_back(static_cast<ViewId>(v));
  }
  return views;
}

MovedPart PartThatMoved(const CameraPart& part, const CameraScene& scene,
                        const std::vector<View>& before, const Eigen::Vector3d& middle) {
  MovedPart moved;
  moved.views = ViewsOf(part, scene.mounts);
  std::vector<View> part_before, part_now;
  for (const ViewId v : moved.views) {
    part_before.push_back(before[v]);
    part_now.push_back(scene.views[v]);
  }
  moved.motion = FindGauge(part_now, part_before, middle).given_from_refined;
  return moved;
}

std::vector<View> OnOtherSide(const CameraPart& part, const Eigen::Affine3d& motion,
                              const CameraScene& scene) {
  std::vector<View> views = Moved(scene.views, motion);
  const std::vector<View> back = Moved(scene.views, motion.inverse());
  for (const ViewId v : ViewsOf(part, scene.mounts)) views[v] = back[v];
  const std::vector<Rigid3d> bodies = BodyPoses(views, scene.mounts);
  for (size_t v = 0; v < views.size(); ++v) {
    const CameraMount& mount = scene.mounts.of_view[v];
    views[v].cam_from_world = mount.view_from_body * bodies[mount.body];
  }
  return views;
}

}  // namespace limn
