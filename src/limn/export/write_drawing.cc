#include "limn/export/write_drawing.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "limn/export/drawing_json.h"
#include "limn/export/drawing_obj.h"
#include "limn/export/drawing_ply.h"
#include "limn/export/sketch_ply.h"
#include "limn/export/tracks.h"
#include "limn/io/atomic_file.h"
#include "limn/util/errors.h"

namespace limn {

void WriteDrawing(const std::string& path, const DrawingGraph& graph,
                  const DrawingMetadata& metadata) {
  const std::vector<std::string> violations = Validate(graph);
  if (!violations.empty()) throw InputError("no valid drawing: " + violations.front());
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension != ".ply" && extension != ".obj" && extension != ".json") {
    throw IoError(path, "unknown extension; drawings are written as .ply, .obj or .json");
  }
  WriteFileAtomically(path, [&](std::ostream& out) {
    if (extension == ".ply") WriteDrawingPly(graph, out);
    if (extension == ".obj") WriteDrawingObj(graph, out);
    if (extension == ".json") WriteDrawingJson(graph, metadata, out);
  });
}

void WriteSketch(const std::string& path, const CurveSketch& sketch) {
  WriteFileAtomically(path, [&](std::ostream& out) { WriteSketchPly(sketch, out); });
}

void WriteTracks(const std::string& path, const DrawingGraph& graph,
                 const std::vector<View>& views) {
  WriteFileAtomically(path, [&](std::ostream& out) { WriteTracks(graph, views, out); });
}

}  // namespace limn
