// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "limn/model/curve_set.h"

namespace limn {

// Readers of the results of Line3D++ (its .obj is read by ReadObjCurves): every segment is a
// polyline; those of no length are left out. Throw IoError.

// One line of the file per line in space: the number of its segments, their ends (X Y Z X Y Z), the
// number of 2D segments that it was made from, and these (camera, segment, x y x y).
CurveSet ReadLine3dppText(const std::string& path);

// STL in text whose facets are segments: the third vertex is the first. Other facets, which have an
// area, are refused.
CurveSet ReadLine3dppStl(const std::string& path);

}  // namespace limn
