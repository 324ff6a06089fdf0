// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/view.h"

namespace limn {

// How far cameras are from the true ones: medians over the views.
struct CameraAccuracy {
  size_t num_views = 0;
  size_t num_wrong = 0;     // of these, too far off to count for the frame; set by callers
  double center = 0;        // distance of centers, in the unit of the world
  double rotation_deg = 0;  // angle of the rotation between them
  double rotation_px = 0;   // that angle times the true focal length
  // Angle between the rays of the two through the same pixel, median over the image, times the true
  // focal length: unlike `rotation_px` it does not count rotations that a principal point explains.
  double ray_px = 0;
  double focal = 0;  // difference of mean focal lengths, relative to the true one
};

// Precondition: the same views in both, in one frame.
CameraAccuracy MeasureCameraAccuracy(const std::vector<View>& views,
                                     const std::vector<View>& true_views);

}  // namespace limn
