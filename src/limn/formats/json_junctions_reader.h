#pragma once

#include <string>
#include <vector>

#include "limn/model/curve_set.h"

namespace limn {

// True junctions as the sample scene has them: a JSON object with "junctions", a list of objects
// with "position" [x, y, z] and "degree"; other members are passed over. They are CurveSet::nodes
// of the truth, and say more than its polylines, which do not share a point where one ends at
// another's middle. Throws IoError.
std::vector<CurveNode> ReadJunctions(const std::string& path);

}  // namespace limn
