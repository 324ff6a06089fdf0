// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "limn/model/curve3d.h"

namespace limn {

// Writes a curve sketch as binary little-endian PLY, for viewing and evaluation: per curve its
// samples as vertices (double x y z, uchar red green blue, double sigma along the viewing ray,
// uchar support = number of supporting edgels, at most 255) and edges between them (int vertex1
// vertex2, uchar red green blue, int link), one color per curve.
void WriteSketchPly(const CurveSketch& sketch, std::ostream& out);

}  // namespace limn
