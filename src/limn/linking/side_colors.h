// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "limn/model/edgel.h"
#include "limn/model/image.h"

namespace limn {

// The colors on the dark and the bright side of an edgel, RGB, gray levels.
using SideColors = std::array<Eigen::Vector3f, 2>;

// Of every edgel, 2.5 px to either side of it; all zero without an image. Linear time.
std::vector<SideColors> MeasureSideColors(const std::vector<Edgel>& edgels, const Image* image);

}  // namespace limn
