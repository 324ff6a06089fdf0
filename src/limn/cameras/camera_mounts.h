// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "limn/geometry/rigid3.h"
#include "limn/model/view.h"

namespace limn {

// A view on the body that carries it.
struct CameraMount {
  int body = -1;
  Rigid3d view_from_body;
};

// Bodies that move: an image, the frame of a rig, a panorama.
struct CameraMounts {
  std::vector<CameraMount> of_view;
  // Bodies that keep the pose they were given.
  std::vector<uint8_t> held;

  size_t NumBodies() const { return held.size(); }
};

// Ascending.
std::vector<ViewId> HeldViews(const CameraMounts& mounts);

// Each view moves alone.
CameraMounts LooseMounts(size_t num_views);

// Per body its pose by the first view on it.
std::vector<Rigid3d> BodyPoses(const std::vector<View>& views, const CameraMounts& mounts);

}  // namespace limn
