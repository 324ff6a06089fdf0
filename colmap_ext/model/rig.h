// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "limn/geometry/rigid3.h"

namespace limn::colmap_ext {

// Rigs and frames (COLMAP 3.12 and later): sensors mounted together, and the instants at which they
// were triggered. cam_from_world = cam_from_rig * rig_from_world.

struct SensorId {
  int32_t type = 0;
  uint32_t id = 0;  // of a camera: its camera_id

  bool operator==(const SensorId&) const = default;
};
constexpr int32_t kCameraSensor = 0;

struct RigSensor {
  SensorId sensor;
  bool has_pose = false;
  Rigid3d sensor_from_rig;
};

struct Rig {
  uint32_t id = 0;
  std::vector<RigSensor> sensors;  // the first, the reference sensor, is the origin of the rig

  int NumCameras() const;
};

// An image, or what another sensor has measured.
struct FrameData {
  SensorId sensor;
  uint64_t id = 0;
};

struct Frame {
  uint32_t id = 0;
  uint32_t rig_id = 0;
  Rigid3d rig_from_world;
  std::vector<FrameData> data;
};

}  // namespace limn::colmap_ext
