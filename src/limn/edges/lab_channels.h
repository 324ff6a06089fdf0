// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "limn/edges/joint_gradient.h"
#include "limn/model/image.h"

namespace limn {

// The channels L, a and b (CIE 1976, D65) of an image of three channels in sRGB, row-major, times
// 2.55: between two grays, L differs by about as much as the gray levels. Linear time.
std::array<std::vector<float>, kMaxChannels> LabChannels(const Image& image);

}  // namespace limn
