#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limn/formats/dxf_drawing_writer.h"
#include "limn/formats/glb_drawing_writer.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/length_unit.h"
#include "limn/formats/svg_drawing_writer.h"
#include "limn/model/curve3d.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

constexpr const char* kAutoFormat = "auto";

// How an SVG picture sees the drawing.
struct SvgPicture {
  // The photograph's view; none: the sheet.
  std::optional<View> view;
  SheetOptions sheet;
  IsHidden is_hidden;
  SvgOptions style;
};

struct DrawingFormatOptions {
  // One of DrawingFormats(), or kAutoFormat: the one that the path's extension names.
  std::string format = kAutoFormat;
  DxfOptions dxf;
  GlbOptions glb;
  SvgPicture svg;
  // What one unit of the coordinates is; for formats that say so (DXF, STEP).
  LengthUnit unit = LengthUnit::kNone;
};

// The names of the formats that drawings are written in: "ply", "obj", ... Those of a build without
// OpenCASCADE lack "step".
std::vector<std::string> DrawingFormats();

// The name of the format that a drawing is written in at this path. Throws IoError if none is.
std::string DrawingFormatOf(const std::string& path, const DrawingFormatOptions& options);

// Write a drawing. The same graph gives the same bytes. The file appears whole or not at all.
// Throws IoError, also for an extension or format that is not known, or InputError if the graph
// breaks an invariant of Validate.
void WriteDrawing(const std::string& path, const DrawingGraph& graph,
                  const DrawingMetadata& metadata, const DrawingFormatOptions& options = {});

// WriteSketchPly and WriteTracks to a path, whole or not at all.
void WriteSketch(const std::string& path, const CurveSketch& sketch);
void WriteTracks(const std::string& path, const DrawingGraph& graph,
                 const std::vector<View>& views);

}  // namespace limn
