// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace limn {

// Where positions and orientations of edges come from: one channel, or L, a and b jointly. Green
// agrees best with the true edges where the lens disperses colors. A gray image has one channel
// only.
enum class EdgeChannel { kGreen, kLuminance, kColor };

}  // namespace limn
