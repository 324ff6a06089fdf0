#pragma once

#include <string>
#include <vector>

#include "limn/model/drawing_graph.h"

namespace limn {

// What a drawing file says beside the graph.
struct DrawingMetadata {
  // Names of the run's views; a link's supporting views are indices into it.
  std::vector<std::string> view_names;
  // The options of the run, as the text of a JSON object.
  std::string options_json = "{}";
};

struct DrawingFile {
  DrawingGraph graph;
  DrawingMetadata metadata;
};

constexpr const char* kDrawingJsonFormat = "limn-drawing";
constexpr int kDrawingJsonVersion = 1;

// A drawing.json as json_drawing_writer.h writes it. Throws IoError, also when the graph breaks one
// of the invariants of Validate.
DrawingFile ReadDrawingJson(const std::string& path);

// The same of the text of one, which messages call `name`.
DrawingFile ParseDrawingJson(const std::string& name, const std::string& text);

}  // namespace limn
