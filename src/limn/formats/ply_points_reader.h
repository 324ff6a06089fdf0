// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include <Eigen/Core>

namespace limn {

struct PlyPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // as in the file; zero if it has none
  std::array<uint8_t, 3> color = {};
  double quality = 0;  // as PMVS writes it; 0 if the file has none, or no number
};

// Streams the vertices of a PLY file of any size: ascii or binary, colors named red or diffuse_red.
// The vertices must be the file's first element and have no lists.
struct PlyPointsInfo {
  uint64_t count = 0;
  bool has_normals = false;
  bool has_colors = false;
};

// Throws IoError.
PlyPointsInfo ReadPlyPointsInfo(const std::string& path);

// Throws IoError with line or byte: too short, or non-finite numbers, unless there is a
// `visit_odd`, which is then called instead with the point as it is (a color that is no number is
// 0).
void ReadPlyPoints(const std::string& path, const std::function<void(const PlyPoint&)>& visit,
                   const std::function<void(const PlyPoint&)>& visit_odd = nullptr);

}  // namespace limn
