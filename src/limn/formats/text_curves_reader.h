// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "limn/model/curve_set.h"

namespace limn {

// Reads points, one "x y z" per line; further columns and lines that start with '#' are ignored.
// The file may be gzipped. Throws IoError.
CurveSet ReadTextPoints(const std::string& path);

// Reads polylines as points plus edges: a second file of 1-based point indices, two per edge, with
// any line breaks (the Pavilion's gt-points.txt and gt-edges.txt). Copies of an edge are merged.
CurveSet ReadIndexedCurves(const std::string& points_path, const std::string& edges_path);

}  // namespace limn
