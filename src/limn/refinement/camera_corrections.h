#pragma once

#include <array>
#include <map>
#include <vector>

#include "limn/model/view.h"

namespace limn {

// Differences between the refined and the given cameras.
struct CameraCorrections {
  // Corrections that change nothing.
  explicit CameraCorrections(const std::vector<View>& views);

  // Per view: x_in_cam = Exp(w) * (given x_in_cam) + m, as w (rad), m (world units).
  std::vector<std::array<double, 6>> motion;
  // Per camera_index the logarithm of the factor on the focal length.
  std::map<int, double> log_focal;
};

// The corrected views. The focal factor acts on the virtual pinhole camera. This is exact without
// lens distortion; with it, pixels off the axis are wrong by about twice the distortion times the
// relative change of the focal length: 0.04 px for a distortion of 20 px and a change of 0.1 %.
std::vector<View> Corrected(const std::vector<View>& views, const CameraCorrections& corrections);

// The parts of a view that a correction changes.
struct PosedCamera {
  PinholeCamera camera;
  Rigid3d cam_from_world;
};
PosedCamera Corrected(const View& view, const double* motion, double log_focal);

}  // namespace limn
