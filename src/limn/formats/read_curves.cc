// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/read_curves.h"

#include <filesystem>

#include "limn/files/whole_file.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/limap_structures.h"
#include "limn/formats/line3dpp_reader.h"
#include "limn/formats/obj_reader.h"
#include "limn/formats/ply_curves_reader.h"
#include "limn/formats/text_curves_reader.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

CurveSet ReadCurvesOfFolder(const std::string& path) {
  const fs::path lines = FindLimapLines(path);
  if (lines.empty()) {
    throw IoError(path, "is a folder without lines of LIMAP (structures/lines3D.bin or .txt)");
  }
  return ReadLimapLines(lines.string());
}

// Points, or lines that only the name of their file tells from points.
CurveSet ReadTextCurves(const std::string& path) {
  const std::string name = fs::path(path).filename().string();
  if (name.starts_with("Line3D++__")) return ReadLine3dppText(path);
  if (name.starts_with("lines3D.")) return ReadLimapLines(path);
  if (name.starts_with("alltracks.")) return ReadLimapTracks(path);
  return ReadTextPoints(path);
}

bool IsLimapBinary(const std::string& path) {
  return fs::path(path).filename().string().starts_with("lines3D.bin");
}

}  // namespace

CurveSet ReadCurves(const std::string& path, const std::string& edges_path) {
  const std::string extension = FileExtension(path);
  const bool is_text = extension == ".txt" || extension == ".xyz";
  if (!edges_path.empty()) {
    if (!is_text) throw IoError(path, "a file of edges goes with points in .txt or .xyz only");
    return ReadIndexedCurves(path, edges_path);
  }
  if (std::error_code ignored; fs::is_directory(path, ignored)) return ReadCurvesOfFolder(path);
  if (is_text) return ReadTextCurves(path);
  if (extension == ".ply") return ReadPlyCurves(path);
  if (extension == ".obj") return ReadObjCurves(path);
  if (extension == ".json") return ToCurveSet(ReadDrawingJson(path).graph);
  if (extension == ".stl") return ReadLine3dppStl(path);
  if (IsLimapBinary(path)) return ReadLimapLines(path);
  throw IoError(path,
                "unknown extension; curves are read from .ply, .obj, .json, .stl, .txt, .xyz, "
                "lines3D.bin and folders of models of LIMAP");
}

}  // namespace limn
