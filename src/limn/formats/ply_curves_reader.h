// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "limn/model/curve_set.h"

namespace limn {

// Reads curves or points from a PLY file: ascii or binary of either byte order, coordinates of any
// type, properties in any order, unknown elements (faces) and properties ignored. Edges are joined
// to polylines by ChainEdges; an edge property `link` names the polyline. A vertex property
// `radius` is that of rods whose center lines the curves are; one that is not positive and finite
// is not known. Throws IoError.
CurveSet ReadPlyCurves(const std::string& path);

}  // namespace limn
