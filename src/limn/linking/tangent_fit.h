// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/curve_fragment.h"

namespace limn {

// Longer arms have less noise and round the bends.
inline constexpr double kTangentArmPx = 4;

// Re-estimates the tangents of the fragment's edgels: a parabola, in the frame of the edgel's
// present tangent, fitted to the positions and directions of the fragment's edgels within `arm_px`
// of arc length, each weighted by its noise. One-sided at the ends. Positions stay; the sense is
// kept.
void RefitTangents(const CurveFragment& fragment, double arm_px, std::vector<Edgel>* edgels);

}  // namespace limn
