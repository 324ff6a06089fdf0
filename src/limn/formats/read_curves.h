// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "limn/model/curve_set.h"

namespace limn {

// Reads curves or points from a file of any supported format, by its extension:
//   .ply               vertices, edges                  ReadPlyCurves
//   .obj               v, l, p                          ReadObjCurves
//   .json              a drawing of limn's              ReadDrawingJson
//   .stl               segments of Line3D++             ReadLine3dppStl
//   .txt .xyz          points, one per line             ReadTextPoints
// by its name:
//   Line3D++__*.txt    segments of Line3D++             ReadLine3dppText
//   lines3D.bin .txt   lines of LIMAP 2.0               ReadLimapLines
//   alltracks.txt      lines of LIMAP 1                 ReadLimapTracks
// or the lines of LIMAP 2.0 from the folder of a model that has them (FindLimapLines). Any file
// may be packed (.gz).
// `edges_path` is the file of edges for a .txt file of points (ReadIndexedCurves), else empty.
// Throws IoError.
CurveSet ReadCurves(const std::string& path, const std::string& edges_path = "");

}  // namespace limn
