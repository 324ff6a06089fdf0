// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/edge_map.h"

#include <cmath>

#include <Eigen/LU>

#include "limn/model/lens_jacobian.h"

namespace limn {
namespace {

bool ApplyLensToEdgel(const LensMap& lens, Edgel* edgel) {
  const auto pixel = ThroughLens(&lens, edgel->position_px);
  if (!pixel) return false;
  const Eigen::Vector2d tangent = pixel->stored_from_virtual.inverse() * edgel->Tangent();
  edgel->position_px = pixel->virtual_px;
  edgel->tangent_rad = std::atan2(tangent.y(), tangent.x());
  edgel->stored_from_virtual = pixel->stored_from_virtual.cast<float>();
  return true;
}

}  // namespace

std::vector<bool> ApplyLens(const LensMap* lens, EdgeMap* edge_map) {
  std::vector<bool> usable(edge_map->edgels.size(), true);
  for (size_t id = 0; id < edge_map->edgels.size(); ++id) {
    Edgel& edgel = edge_map->edgels[id];
    edgel.stored_px = edgel.position_px.cast<float>();
    if (!lens || ApplyLensToEdgel(*lens, &edgel)) continue;
    edgel.strength = 0;
    usable[id] = false;
    ++edge_map->num_outside_lens;
  }
  return usable;
}

}  // namespace limn
