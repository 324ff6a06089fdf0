// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limn/files/output_path.h"
#include "limn/formats/dxf/dxf_drawing_writer.h"
#include "limn/formats/glb_drawing_writer.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/obj_drawing_writer.h"
#include "limn/formats/step/step_drawing_writer.h"
#include "limn/formats/svg/svg_drawing_writer.h"
#include "limn/model/curve3d.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/link_selection.h"
#include "limn/model/reduce_to_wireframe.h"
#include "limn/model/view.h"
#include "limn/util/length_unit.h"

namespace limn {

constexpr const char* kAutoFormat = "auto";

// How an SVG picture sees the drawing.
struct SvgPicture {
  // The view of the photograph; none: use the sheet.
  std::optional<View> view;
  SheetOptions sheet;
  IsHidden is_hidden;
  SvgOptions style;
};

struct DrawingFormatOptions {
  // One of DrawingFormats(), or kAutoFormat: by the path's extension.
  std::string format = kAutoFormat;
  ObjOptions obj;
  DxfOptions dxf;
  GlbOptions glb;
  StepOptions step;
  // &WriteDrawingStep; without it no STEP files are written.
  StepFileWriter write_step = nullptr;
  SvgPicture svg;
  WireframeOptions wireframe;
  // Of the coordinates: formats that have a unit of their own are converted to it (STEP, GLB),
  // others tell it.
  LengthUnit unit = LengthUnit::kNone;
};

// The names of the formats for drawings: "ply", "obj", ..., "faces", a .ply file of the faces
// alone, and "wireframe", an .obj or .json file of corners and straight edges.
std::vector<std::string> DrawingFormats();

// The name of the format of a drawing written to this path. Throws IoError if there is none.
std::string DrawingFormatOf(const std::string& path, const DrawingFormatOptions& options);

// Writes a drawing atomically. The same graph gives the same bytes. Throws IoError, also for an
// unknown extension or format or one that does not hold the other, or InputError if Validate finds
// something wrong with the graph or its alignment. Returns a sentence for each thing that the
// format cannot hold.
std::vector<std::string> WriteDrawing(const OutputPath& path, const DrawingGraph& graph,
                                      const DrawingMetadata& metadata,
                                      const DrawingFormatOptions& options = {});

// WriteSketchPly and WriteTracks to a path, atomically.
void WriteSketch(const OutputPath& path, const CurveSketch& sketch);
void WriteTracks(const OutputPath& path, const DrawingGraph& graph, const LinkSelection& selection,
                 const std::vector<View>& views);

}  // namespace limn
