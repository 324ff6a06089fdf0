#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/model/view.h"

namespace limn {

// What a camera knew of itself when it took a photograph.
struct ViewPrior {
  // In meters, z up: its center, and the standard deviation of that along each axis; 0 = unknown.
  std::optional<Eigen::Vector3d> position;
  double position_sigma = 0;
  // Which way things fall, in the camera's coordinates (x right, y down, z forward).
  std::optional<Eigen::Vector3d> gravity_in_cam;
};

// Gravity exactly along an axis of the camera, which is not measured: COLMAP makes it from the
// orientation flag of a photograph.
bool IsOrientationFlag(const Eigen::Vector3d& gravity_in_cam);

// Whether the camera measured gravity; orientation flags do not count.
bool MeasuredGravity(const ViewPrior& prior);

struct GravityUp {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  // Of the cameras' measurements from it, median.
  double deviation_rad = 0;
  size_t num_views = 0;
};

// One or two measurements cannot be seen to be wrong.
constexpr size_t kMinGravities = 3;

// The median of what gravity tells in all cameras that measured it; nothing if fewer than
// kMinGravities did, or if they cancel. `priors` has one per view, or is empty.
std::optional<GravityUp> MeasuredUp(const std::vector<View>& views,
                                    const std::vector<ViewPrior>& priors);

// Roughly up, as cameras are held: their x axes are mostly horizontal (the axis that gravity tells
// to be, if it is known at least to a quarter turn), and their y axes mostly point down;
// where these cancel, the cameras look down.
Eigen::Vector3d UpOfCameras(const std::vector<View>& views, const std::vector<ViewPrior>& priors);

}  // namespace limn
