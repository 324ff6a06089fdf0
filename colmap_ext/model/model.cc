// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/model.h"

#include <algorithm>

namespace limn::colmap_ext {

const Camera& SparseModel::CameraOf(const ModelImage& image) const {
  return *std::find_if(cameras.begin(), cameras.end(),
                       [&](const Camera& camera) { return camera.id == image.camera_id; });
}

uint64_t NextPointId(const SparseModel& model) {
  uint64_t next = 1;
  for (const ModelPoint& point : model.points) next = std::max(next, point.id + 1);
  return next;
}

}  // namespace limn::colmap_ext
