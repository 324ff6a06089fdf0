// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limn/model/alignment.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// What a drawing file contains besides the graph.
struct DrawingMetadata {
  // Names of the run's views; a link's supporting views are indices into it.
  std::vector<std::string> view_names;
  // The options of the run, as the text of a JSON object.
  std::string options_json = "{}";
  // Where the drawing is in the world, if it was aligned. The graph is in the model's coordinates.
  std::optional<Alignment> alignment = std::nullopt;
  // Unit vector in the model: along which most of the cameras look. None if that is unknown.
  std::optional<Eigen::Vector3d> main_view_direction = std::nullopt;
  // Names refined cameras that the drawing fits; empty if it fits those that were given.
  std::string refined_cameras = "";
};

// Of the drawing whose coordinates were changed by file_from_model.
DrawingMetadata After(const Similarity3d& file_from_model, DrawingMetadata metadata);

struct DrawingFile {
  DrawingGraph graph;
  DrawingMetadata metadata;
};

constexpr const char* kDrawingJsonFormat = "limn-drawing";
constexpr int kDrawingJsonVersion = 1;

// Reads a drawing.json as written by json_drawing_writer.h, with numbers up to 1e15. Throws IoError
// with the place; also if the graph or the alignment violates an invariant of Validate.
DrawingFile ReadDrawingJson(const std::string& path);

// The same from the text of a file, called `name` in messages.
DrawingFile ParseDrawingJson(const std::string& name, const std::string& text);

// DrawingMetadata::refined_cameras, from the beginning of a drawing.json. Empty if it has none, or
// cannot be read.
std::string RefinedCamerasOfDrawing(const std::string& path);

}  // namespace limn
