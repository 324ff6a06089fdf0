// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace limn {

// What is this near to an edgel, virtual px, and has nearly its direction (cosine of the angle)
// shows the same edge.
constexpr double kSameEdgePx = 1.5;
constexpr double kSameDirectionCosine = 0.9;

// Whether curves at these depths in a view are different ones: by a factor of more than 1.15.
// Before things that repeat in step with the cameras, edges of many depths fit the same edgels.
inline bool AreAtOtherDepths(float a, float b) {
  constexpr float kOtherDepth = 1.15F;
  return std::max(a, b) > kOtherDepth * std::min(a, b);
}

}  // namespace limn
