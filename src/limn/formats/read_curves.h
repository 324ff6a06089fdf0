#pragma once

#include <string>

#include "limn/model/curve_set.h"

namespace limn {

// Curves or points of any file limn knows, by its extension:
//   .ply               vertices, edges                  ReadPlyCurves
//   .obj               v, l, p                          ReadObjCurves
//   .json              a drawing of limn's              ReadDrawingJson
//   .txt .xyz (.gz)    points, one per line             ReadTextPoints
// `edges_path` gives the edges of a .txt file of points (ReadIndexedCurves) and is empty otherwise.
// Throws IoError.
CurveSet ReadCurves(const std::string& path, const std::string& edges_path = "");

}  // namespace limn
