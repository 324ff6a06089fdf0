// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "limn/model/image.h"

namespace limn {

// How sharp a photograph is: the median blur of its strong edges, px of the photograph, as the
// standard deviation of the Gaussian that a step seems to be convolved with (its pixels are part of
// it: 0.3 for the sharpest). Green, or gray, at a scale of 1 px: an edge whose gradient is I_n and
// third derivative I_nnn there has the variance -I_n / I_nnn - 1 (ours, after the blur estimate of
// Elder and Zucker, "Local scale control for edge detection and blur estimation", PAMI 1998). Edges
// near each other look sharper than they are; sharpened ones have 0. Nothing if there are too few
// strong edges to tell. Precondition: the image's scale is 1. Time: linear in pixels.
std::optional<double> MeasureEdgeBlur(const Image& image);

}  // namespace limn
