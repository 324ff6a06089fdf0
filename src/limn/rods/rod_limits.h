// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace limn {

// Half the thickness of a rod, px. Edges nearer to each other blur into one.
constexpr double kMinRadiusPx = 0.7;
constexpr double kMaxRadiusPx = 3.5;
// Distance of the points of an axis, px.
constexpr double kAxisStepPx = 6;

}  // namespace limn
