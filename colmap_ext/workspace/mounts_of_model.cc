// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/mounts_of_model.h"

#include <map>
#include <utility>

#include "colmap_ext/model/mounted_images.h"

namespace limn::colmap_ext {

CameraMounts MountsOf(const SparseModel& model, const ViewSet& set) {
  std::map<size_t, MountedImage> mounted;
  for (const MountedImage& image : MountedImages(model)) mounted.emplace(image.image, image);
  // Whether it is a frame, and its index or that of the image.
  std::map<std::pair<bool, size_t>, int> bodies;
  CameraMounts mounts;
  for (size_t v = 0; v < set.views.size(); ++v) {
    const size_t image = set.views[v].model_index;
    const auto at = mounted.find(image);
    const bool is_mounted = at != mounted.end();
    const auto body = bodies.emplace(std::pair(is_mounted, is_mounted ? at->second.frame : image),
                                     static_cast<int>(bodies.size()));
    Rigid3d view_from_body = {set.files[v].view_from_image, Eigen::Vector3d::Zero()};
    if (is_mounted) {
      const RigSensor& sensor = model.rigs[at->second.rig].sensors[at->second.sensor];
      view_from_body = view_from_body * sensor.sensor_from_rig;
    }
    mounts.of_view.push_back({body.first->second, view_from_body});
  }
  mounts.held.assign(bodies.size(), 0);
  return mounts;
}

}  // namespace limn::colmap_ext
