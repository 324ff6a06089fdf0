// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "limn/model/curve_set.h"

namespace limn {

// Writes curves and points as binary little-endian PLY: per polyline its points as vertices (double
// x y z, uchar red green blue), then the other points; edges between vertices of a polyline (int
// vertex1 vertex2, uchar red green blue, int link), one color per polyline. Nodes are not written.
void WriteCurvesPly(const CurveSet& set, std::ostream& out);

}  // namespace limn
