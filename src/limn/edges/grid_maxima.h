#pragma once

#include <cstdint>
#include <vector>

#include "limn/edges/gaussian_derivatives.h"

namespace limn {

// Gradient magnitude on the pixel grid, row-major, gray levels per px.
std::vector<float> GradientMagnitude(const GradientField& gradient);

// Which pixels of row y, 1 <= y < height - 1, are near a maximum of the gradient magnitude along
// the gradient, as far as the pixel grid tells: worth a refinement. near_maximum[x], x < width, is
// not 0 where the magnitude is above `lowest` and there is a maximum within about the distance that
// a refinement may go; 0 in the first and last column and in images narrower than 6 px. Linear
// time, four pixels at once.
//
// The maximum is found by a step of Newton's method on the logarithm of three magnitudes: of the
// pixel, and of the places ahead and behind where the line along the gradient leaves its 3 x 3
// neighborhood, interpolated.
void FindGridMaxima(const GradientField& gradient, const std::vector<float>& magnitude, int y,
                    float lowest, int32_t* near_maximum);

}  // namespace limn
