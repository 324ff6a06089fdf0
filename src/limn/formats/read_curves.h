#pragma once

#include <string>

#include "limn/model/curve_set.h"

namespace limn {

// Reads curves or points from a file of any supported format, by its extension:
//   .ply               vertices, edges                  ReadPlyCurves
//   .obj               v, l, p                          ReadObjCurves
//   .json              a drawing of limn's              ReadDrawingJson
//   .txt .xyz          points, one per line             ReadTextPoints
// Any of them may be packed (.gz).
// `edges_path` is the file of edges for a .txt file of points (ReadIndexedCurves), else empty.
// Throws IoError.
CurveSet ReadCurves(const std::string& path, const std::string& edges_path = "");

}  // namespace limn
