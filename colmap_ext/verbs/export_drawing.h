// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "colmap_ext/host/console.h"
#include "colmap_ext/options/option_parser.h"
#include "colmap_ext/verbs/selection_options.h"
#include "colmap_ext/verbs/svg_source.h"
#include "colmap_ext/workspace/layout.h"
#include "limn/formats/write_drawing.h"
#include "limn/model/drawing_transform.h"

namespace limn::colmap_ext {

// The options of drawing_exporter.
struct ExporterOptions {
  // The drawing; empty: the newest one of the workspace.
  std::string input_path;
  std::string output_path;
  LayoutOptions workspace;
  // Replace an output that is also an input, a drawing.json or a file that limn did not write.
  bool overwrite = false;
  bool junctions = true;
  SelectionOptions selection;
  // GLB and STEP: rods as tubes of their radius.
  bool rods_as_tubes = false;
  // DXF: links with curved primitives as the polylines of their points. OBJ: see ObjOptions.
  bool segments = false;
  std::string cloud_path;
  DrawingFormatOptions format;
  double scale = 1;
  SignedAxis up_axis = SignedAxis::kZ;
  // In world coordinates, by the alignment of the drawing, instead of the model's.
  bool aligned = false;
  SvgSource svg;
  // Dimensions with their standard deviations.
  bool sigmas = false;
  // Of DXF plans (FlatOptions).
  bool regularize = true;
  // LIMAP: include links that are not straight.
  bool chains = false;
  // COLMAP: distance of the points along curves.
  double point_spacing_px = 2;

  void AddOptions(OptionParser* parser);
  // Sections are horizontal in the aligned world.
  bool IsAligned() const;
  // Throws OptionError.
  void Check() const;
};

// Reads the drawing and what is exported with it, aligned, rotated and scaled, and writes it.
// Returns the number of links. Throws IoError, also if the output must not be replaced or the
// drawing has no alignment that is asked for, InputError, and OptionError for a view that does not
// exist.
size_t ExportDrawing(const ExporterOptions& options, Console* console);
// The same for a drawing that was read.
size_t ExportDrawing(DrawingFile drawing, const ExporterOptions& options, Console* console);

// drawing_exporter: the first, and says what was written.
void RunExporter(const ExporterOptions& options, Console* console);

}  // namespace limn::colmap_ext
