// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/cameras/camera_mounts.h"
#include "limn/model/view.h"
#include "limn/support/edgel_residual.h"

namespace limn {

// Per parameter of a calibration, px.
using ParameterRow = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, 16>;

// A line in the image of a view onto which a landmark should project.
struct LandmarkLine {
  ViewId view = -1;
  EdgelLine line;
  double weight = 0;  // 1 / px^2
  // Change of the distance with the parameters of the camera.
  ParameterRow by_parameters = {};
};

// A place in space that several views see.
struct Landmark {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  // How it can move, a column each, world units per px: in all directions, or across a curve.
  Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3> ways;
  double robust_px = 0.5;  // scale of the Cauchy loss
  int curve = -1;          // whose landmarks follow one another; -1: none
  std::vector<LandmarkLine> lines;
};

// Per body, whether it belongs to a part of the cameras that moves as one.
using CameraPart = std::vector<uint8_t>;

struct PartMotion {
  Eigen::Vector3d middle;
  CameraPart part;  // empty: that which is most off (FindPart)
};

// What is adjusted, and where it was given.
struct CameraFitInput {
  const std::vector<View>& views;
  const CameraMounts& mounts;
  // Per body its given pose, and the distance of the scene, world units.
  std::vector<Rigid3d> given_poses;
  std::vector<double> distances;
  // Per camera that is adjusted, how far its parameters are from the given ones. Each is counted in
  // px: by how much it moves the border of an image.
  std::map<int, Eigen::VectorXd> parameters;
  bool with_covariance = false;
  std::optional<PartMotion> part = {};  // if set: nothing else moves
};

}  // namespace limn
