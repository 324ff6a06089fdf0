#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "limn/model/curve3d.h"

namespace limn {

// A curve of the sketch on its way to where its edgels agree. One entry per sample.
struct WorkingCurve {
  std::vector<Eigen::Vector3d> position;
  std::vector<Eigen::Vector3d> tangent;
  std::vector<Eigen::Matrix3d> information;
  std::vector<double> footprint;
  std::vector<std::vector<EdgelRef>> support;
  std::vector<uint8_t> supported;  // by enough views, in the end
  bool closed = false;

  int size() const { return static_cast<int>(position.size()); }
};

}  // namespace limn
