#pragma once

#include <array>
#include <map>
#include <vector>

#include "limn/model/view.h"

namespace limn {

// How the cameras differ from those that were given.
struct CameraCorrections {
  // Per view: x_in_cam = Exp(w) * (given x_in_cam) + m, as w (rad), m (world units).
  std::vector<std::array<double, 6>> motion;
  // Per camera_index the logarithm of the factor on the focal length.
  std::map<int, double> log_focal;
};

// Corrections that change nothing.
CameraCorrections NoCorrections(const std::vector<View>& views);

// The corrected views. The factor acts on the virtual pinhole camera: exact without lens
// distortion; with it, rays off the axis differ by about twice the distortion in px times the
// relative change of the focal length: 0.04 px where it is 20 px, for a change of 0.1 %.
std::vector<View> Corrected(const std::vector<View>& views, const CameraCorrections& corrections);

// What a correction changes of a view.
struct PosedCamera {
  PinholeCamera camera;
  Rigid3d cam_from_world;
};
PosedCamera Corrected(const View& view, const double* motion, double log_focal);

}  // namespace limn
