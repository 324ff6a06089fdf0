// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "limn/model/curve_set.h"

namespace limn {

// Reads true curves with their kinds:
//   {"curves": [{"kind": "edge"|"paint"|"shadow"|"contour"|"rod", "points": [[x, y, z], ...]},
//   ...]}
// with rods by their center lines.
// Indexed by LinkKind. Throws IoError.
std::array<CurveSet, kNumLinkKinds> ReadJsonKinds(const std::string& path);

}  // namespace limn
