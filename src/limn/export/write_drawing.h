#pragma once

#include <string>
#include <vector>

#include "limn/io/drawing_json_reader.h"
#include "limn/model/curve3d.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

// Write a drawing in the format of the path's extension: .ply, .obj or .json. The same graph gives
// the same bytes. The file appears whole or not at all. Throws IoError, or InputError if the graph
// breaks an invariant of Validate.
void WriteDrawing(const std::string& path, const DrawingGraph& graph,
                  const DrawingMetadata& metadata);

// WriteSketchPly and WriteTracks to a path, whole or not at all.
void WriteSketch(const std::string& path, const CurveSketch& sketch);
void WriteTracks(const std::string& path, const DrawingGraph& graph,
                 const std::vector<View>& views);

}  // namespace limn
