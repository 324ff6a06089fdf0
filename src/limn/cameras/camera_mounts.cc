// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cameras/camera_mounts.h"

namespace limn {

std::vector<ViewId> HeldViews(const CameraMounts& mounts) {
  std::vector<ViewId> views;
  for (size_t v = 0; v < mounts.of_view.size(); ++v) {
    if (mounts.held[mounts.of_view[v].body]) views.push_back(static_cast<ViewId>(v));
  }
  return views;
}

CameraMounts LooseMounts(size_t num_views) {
  CameraMounts mounts;
  for (size_t v = 0; v < num_views; ++v) mounts.of_view.push_back({static_cast<int>(v), {}});
  mounts.held.assign(num_views, 0);
  return mounts;
}

std::vector<Rigid3d> BodyPoses(const std::vector<View>& views, const CameraMounts& mounts) {
  std::vector<Rigid3d> poses(mounts.NumBodies());
  for (size_t v = views.size(); v-- > 0;) {
    const CameraMount& mount = mounts.of_view[v];
    poses[mount.body] = Inverse(mount.view_from_body) * views[v].cam_from_world;
  }
  return poses;
}

}  // namespace limn
