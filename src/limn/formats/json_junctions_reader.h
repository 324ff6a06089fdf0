// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "limn/model/curve_set.h"

namespace limn {

// Reads true junctions in the format of the sample scene: a JSON object with "junctions", a list of
// objects with "position" [x, y, z], "degree" and, if it is known, "kind": "corner", "t" or
// "crossing"; other kinds and members are ignored. They become CurveSet::nodes of the truth, whose
// polylines share no point where one ends at the middle of another. Throws IoError.
std::vector<CurveNode> ReadJunctions(const std::string& path);

}  // namespace limn
