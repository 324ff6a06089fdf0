// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace limn {

// Epipolar tangency: where a curve runs along the epipolar lines of a view, the view supports it at
// any depth. Below the first angle to them, degrees, a view has the least weight, above the second
// one, where depth is as well determined as elsewhere, full weight.
inline constexpr double kMinEpipolarAngleDeg = 3;
inline constexpr double kMaxEpipolarAngleDeg = 15;
// More than nothing: such a view still sees an edge there.
inline constexpr double kMinTangencyWeight = 0.1;

}  // namespace limn
