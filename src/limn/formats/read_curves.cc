#include "limn/formats/read_curves.h"

#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/obj_reader.h"
#include "limn/formats/ply_curves_reader.h"
#include "limn/formats/text_curves_reader.h"
#include "limn/formats/whole_file.h"
#include "limn/util/errors.h"

namespace limn {

CurveSet ReadCurves(const std::string& path, const std::string& edges_path) {
  const std::string extension = FileExtension(path);
  const bool is_text = extension == ".txt" || extension == ".xyz";
  if (!edges_path.empty()) {
    if (!is_text) throw IoError(path, "a file of edges goes with points in .txt or .xyz only");
    return ReadIndexedCurves(path, edges_path);
  }
  if (is_text) return ReadTextPoints(path);
  if (extension == ".ply") return ReadPlyCurves(path);
  if (extension == ".obj") return ReadObjCurves(path);
  if (extension == ".json") return ToCurveSet(ReadDrawingJson(path).graph);
  throw IoError(path, "unknown extension; curves are read from .ply, .obj, .json, .txt, .xyz");
}

}  // namespace limn
