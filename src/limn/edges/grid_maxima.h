// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "limn/edges/gaussian_derivatives.h"

namespace limn {

// Gradient magnitude on the pixel grid, row-major, gray levels per px.
std::vector<float> GradientMagnitude(const GradientField& gradient);

// Finds the pixels of row y, 1 <= y < height - 1, that are worth refining. near_maximum[x], x <
// width, is nonzero where the magnitude is above `lowest` and, judging by the pixel grid, has a
// maximum along the gradient within about the distance that a refinement may move; 0 in the first
// and last column and in images narrower than 6 px. Linear time, four pixels at once.
//
// The maximum is found by a Newton step on the logarithm of three magnitudes: that of the pixel,
// and those interpolated where the line along the gradient leaves its 3 x 3 neighborhood.
void FindGridMaxima(const GradientField& gradient, const std::vector<float>& magnitude, int y,
                    float lowest, int32_t* near_maximum);

}  // namespace limn
