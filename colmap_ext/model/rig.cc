// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/rig.h"

#include <algorithm>

namespace limn::colmap_ext {

int Rig::NumCameras() const {
  return static_cast<int>(
      std::count_if(sensors.begin(), sensors.end(),
                    [](const RigSensor& sensor) { return sensor.sensor.type == kCameraSensor; }));
}

}  // namespace limn::colmap_ext
