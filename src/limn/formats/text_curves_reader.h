#pragma once

#include <string>

#include "limn/model/curve_set.h"

namespace limn {

// Points, one "x y z" per line; further columns are passed over, as are lines that start with '#'.
// The file may be gzipped. Throws IoError.
CurveSet ReadTextPoints(const std::string& path);

// Polylines as points plus edges: a second file of 1-based point indices, two per edge, in any
// layout of lines (the Pavilion's gt-points.txt and gt-edges.txt). Copies of an edge are one edge.
CurveSet ReadIndexedCurves(const std::string& points_path, const std::string& edges_path);

}  // namespace limn
