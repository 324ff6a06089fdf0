// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/model/view.h"

namespace limn {

// What a camera recorded about its own pose when it took a photograph.
struct ViewPrior {
  // In meters, z up: its center, and the standard deviation of that along each axis; 0 = unknown.
  std::optional<Eigen::Vector3d> position;
  double position_sigma = 0;
  bool is_geographic = false;  // the position was measured by satellites
  // Of a geographic one: where it would be with latitude and longitude exchanged.
  std::optional<Eigen::Vector3d> exchanged_position;
  // Which way things fall, in the camera's coordinates (x right, y down, z forward).
  std::optional<Eigen::Vector3d> gravity_in_cam;
};

// Gravity exactly along an axis of the camera was not measured: COLMAP derives it from the
// orientation flag of a photograph.
bool IsOrientationFlag(const Eigen::Vector3d& gravity_in_cam);

// Whether the camera measured gravity; orientation flags do not count.
bool MeasuredGravity(const ViewPrior& prior);

struct GravityUp {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  // Median deviation of the cameras' measurements from it.
  double deviation_rad = 0;
  size_t num_views = 0;
};

// With fewer measurements a wrong one cannot be recognized.
constexpr size_t kMinGravities = 3;

// The median direction from gravity over all cameras that measured it; nothing if fewer than
// kMinGravities did, or if they cancel. `priors` has one per view, or is empty.
std::optional<GravityUp> MeasuredUp(const std::vector<View>& views,
                                    const std::vector<ViewPrior>& priors);

// Up in the world as this photograph is held: above its upper side, or, if gravity is known at
// least to a quarter turn, against that.
Eigen::Vector3d UpAsHeld(const View& view, const ViewPrior& prior);

// Roughly up, from how cameras are held: their x axes are mostly horizontal (or whichever axis
// gravity says is, if it is known at least to a quarter turn), and their y axes mostly point down;
// if these cancel, the cameras look down.
Eigen::Vector3d UpOfCameras(const std::vector<View>& views, const std::vector<ViewPrior>& priors);

// The direction along which most cameras look: that which has most within 45 degrees, then the mean
// of these. Precondition: there are cameras. Time: the square of their number.
Eigen::Vector3d MainViewDirection(const std::vector<View>& views);

}  // namespace limn
